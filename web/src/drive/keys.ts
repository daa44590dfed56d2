import { no_request, strongest } from "./drive_request";
import type { DriveRequest } from "./drive_request";

const key_requests: Record<string, DriveRequest> = {
  ArrowUp: { ahead: 1, left: 0 },
  ArrowDown: { ahead: -1, left: 0 },
  ArrowLeft: { ahead: 0, left: 1 },
  ArrowRight: { ahead: 0, left: -1 },
};

/** Whether the focused control uses the arrow keys itself. */
function wants_arrows(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement && target.matches("input, select, textarea, [role=slider], [data-arrows]")
  );
}

/**
 * Reports the held arrow keys as one request.
 * @param active whether the arrow keys drive now; if not, they keep their usual meaning in the page
 */
export function watch_keys(active: () => boolean, report: (request: DriveRequest) => void): void {
  const held = new Set<string>();
  const changed = () => report(strongest([...held].map((key) => key_requests[key] ?? no_request)));
  const release_all = () => {
    held.clear();
    changed();
  };

  addEventListener(
    "keydown",
    (event) => {
      if (!(event.key in key_requests) || event.ctrlKey || event.altKey || event.metaKey) return;
      if (!active() || wants_arrows(event.target)) return;
      event.preventDefault();
      event.stopPropagation();
      held.add(event.key);
      if (!event.repeat) changed();
    },
    { capture: true },
  );
  addEventListener("keyup", (event) => {
    if (held.delete(event.key)) changed();
  });
  addEventListener("blur", release_all);
  document.addEventListener("visibilitychange", release_all);
}
