/** Files stored on the server, over HTTP. */

import { server_address } from "./access";

/** The address of a file, with the access token if the server needs one. */
export function file_address(path: string): string {
  return server_address(path).href;
}

async function problems_of(response: Response): Promise<string> {
  try {
    const { problems } = (await response.json()) as { problems: string[] };
    return problems.join("; ");
  } catch {
    return `${response.status} ${response.statusText}`;
  }
}

export async function get_json<T>(path: string): Promise<T> {
  const response = await fetch(file_address(path), { cache: "no-store" });
  if (!response.ok) throw new Error(await problems_of(response));
  return (await response.json()) as T;
}

export async function post_text<T>(path: string, text: string, lease: string): Promise<T> {
  const headers = { "content-type": "application/json", "x-aisle-lease": lease };
  const response = await fetch(file_address(path), { method: "POST", body: text, headers });
  if (!response.ok) throw new Error(await problems_of(response));
  return (await response.json()) as T;
}

/** Offers bytes to the user as a download. */
export function download(name: string, bytes: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(bytes);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

export function download_text(name: string, text: string): void {
  download(name, new Blob([text], { type: "text/plain" }));
}
