import type { LiveConnection } from "../connection/live_connection";
import { element } from "./element";
import { file_address } from "./server_files";

/** Whether the server answers, and lets nobody in without another token than this page's address bears. */
async function is_locked(): Promise<boolean> {
  const response = await fetch(file_address("sessions/"), { cache: "no-store" }).catch(() => undefined);
  return response?.status === 401;
}

/** Asks for the token where the server wants one that the page's address does not bear. */
export function token_form(connection: LiveConnection): HTMLElement {
  const token = element("input", { type: "password", required: true, autocomplete: "current-password" });
  const gate = element(
    "form",
    {
      class: "panel token-form",
      hidden: true,
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        const address = new URL(location.href);
        address.searchParams.set("token", token.value.trim());
        location.assign(address);
      },
    },
    element("label", { class: "field" }, element("span", {}, "Token of this vehicle"), token),
    element("button", { type: "submit", class: "primary" }, "Enter"),
  );
  connection.state.watch((state) => {
    if (state === "connected") gate.hidden = true;
    if (state === "lost") void is_locked().then((locked) => (gate.hidden = !locked));
  });
  return gate;
}
