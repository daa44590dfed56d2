/** Ctrl+Z undoes, Ctrl+Shift+Z and Ctrl+Y redo; in text fields the keys keep their own meaning. */
export function watch_undo_keys(active: () => boolean, step: (by: "undo" | "redo") => void): void {
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !active()) return;
    if (event.target instanceof HTMLInputElement && event.target.type !== "checkbox") return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    step(key === "y" || event.shiftKey ? "redo" : "undo");
  });
}
