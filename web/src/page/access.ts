/** The access token: taken out of the page's address, where others could read it, and kept for this tab. */

const storage_key = "aisle.token";

export function take_token_from_address(): void {
  const address = new URL(location.href);
  const token = address.searchParams.get("token");
  if (token === null) return;
  sessionStorage.setItem(storage_key, token);
  address.searchParams.delete("token");
  history.replaceState(null, "", address);
}

export function present_token(): string | null {
  return sessionStorage.getItem(storage_key);
}

export function keep_token(token: string): void {
  sessionStorage.setItem(storage_key, token);
}

/** An address of the server, with the token if there is one. */
export function server_address(path: string): URL {
  const address = new URL(path, new URL(".", location.href));
  const token = present_token();
  if (token !== null) address.searchParams.set("token", token);
  address.hash = "";
  return address;
}

export function socket_address(): string {
  const address = server_address("");
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  return address.href;
}
