import type { LiveConnection } from "../connection/live_connection";
import { element } from "./element";
import { file_address } from "./server_files";

/** Whether the server answers but refuses the token in the page's address, or the lack of one. */
async function is_locked(): Promise<boolean> {
  const response = await fetch(file_address("sessions/"), { cache: "no-store" }).catch(() => undefined);
  return response?.status === 401;
}

/** Asks for the access token if the server needs one and the page's address has none or a wrong one. */
export function token_form(connection: LiveConnection): HTMLElement {
  const token = element("input", { type: "password", required: true, autocomplete: "current-password" });
  const form = element(
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
    if (state === "connected") form.hidden = true;
    if (state === "lost") void is_locked().then((locked) => (form.hidden = !locked));
  });
  return form;
}
