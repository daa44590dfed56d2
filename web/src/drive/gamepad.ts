import { is_wish, no_wish } from "./wish";
import type { Wish } from "./wish";

const dead = 0.15;

function axis(value: number | undefined): number {
  return value !== undefined && Math.abs(value) > dead ? value : 0;
}

function wish_of(pad: Gamepad): Wish {
  return { ahead: -axis(pad.axes[1]) + 0, left: -axis(pad.axes[0]) + 0 };
}

/** The left stick of any gamepad; polled only while one is there. */
export function watch_gamepads(tell: (wish: Wish) => void): void {
  let polling = false;
  let told = no_wish;
  const poll = () => {
    const pads = navigator.getGamepads().filter((pad) => pad !== null);
    const wish = pads.map(wish_of).find(is_wish) ?? no_wish;
    if (wish.ahead !== told.ahead || wish.left !== told.left) tell((told = wish));
    polling = pads.length > 0;
    if (polling) requestAnimationFrame(poll);
  };
  addEventListener("gamepadconnected", () => {
    if (!polling) poll();
  });
}
