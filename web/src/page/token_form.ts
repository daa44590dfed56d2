import type { LiveConnection } from "../connection/live_connection";
import { text } from "../text";
import { keep_token, present_token } from "./access";
import { element, set_text } from "./element";
import { file_address } from "./server_files";

/** Whether the server answers but refuses the token, or the lack of one. */
async function is_locked(): Promise<boolean> {
  const response = await fetch(file_address("sessions/"), { cache: "no-store" }).catch(() => undefined);
  return response?.status === 401;
}

/** Asks for the access token if the server needs one and the page has none or a wrong one. */
export function token_form(connection: LiveConnection): HTMLElement {
  const token = element("input", { type: "password", required: true, autocomplete: "current-password" });
  const about = element("p", { class: "about", role: "alert" });
  const form = element(
    "form",
    {
      class: "panel token-form",
      hidden: true,
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        keep_token(token.value.trim());
        location.reload();
      },
    },
    about,
    element("label", { class: "field" }, element("span", {}, text.token.label), token),
    element("button", { type: "submit", class: "primary" }, text.token.enter),
  );
  connection.state.watch((state) => {
    if (state === "connected") form.hidden = true;
    if (state !== "lost") return;
    void is_locked().then((locked) => {
      form.hidden = !locked;
      if (locked) set_text(about, present_token() === null ? text.token.needed : text.token.wrong);
    });
  });
  return form;
}
