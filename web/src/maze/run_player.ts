import { button, element, set_text } from "../page/element";
import { text } from "../text";
import { draw_input } from "./maze_drawing";
import { false_walls, known_after } from "./maze_run";
import type { MazeRun } from "./maze_run";

const input_px = 76;
/** A long stack would take longer to lay out than a frame. */
const stack_shown = 40;

/** Steps through a run: state, input, rule and stack of each learning cycle. */
export class RunPlayer {
  readonly element: HTMLElement;
  readonly #slider = element("input", {
    type: "range",
    min: 1,
    max: 1,
    value: 1,
    "aria-label": text.maze.cycle,
  });
  readonly #speed = element("input", {
    type: "range",
    min: 0,
    max: 100,
    value: 45,
    "aria-label": text.maze.speed,
  });
  readonly #play: HTMLButtonElement;
  readonly #position = element("span", { class: "position" });
  readonly #input = element("canvas", {
    width: input_px,
    height: input_px,
    role: "img",
    class: "input-drawing",
  });
  readonly #state = element("dd", {});
  readonly #symbol = element("dd", {});
  readonly #rule = element("dd", { class: "rule" });
  readonly #move = element("dd", {});
  readonly #stack = element("ol", { class: "stack", tabindex: 0, "aria-label": text.maze.stack });
  readonly #figures = element("p", { class: "about", role: "status" });
  #run: MazeRun | undefined;
  #count = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** @param show called with the number of cycles to show */
  constructor(private readonly show: (count: number) => void) {
    this.#play = button(text.maze.run, () => this.#toggle());
    this.#slider.addEventListener("input", () => {
      this.pause();
      this.go_to(Number(this.#slider.value));
    });
    const step = (by: number) => () => {
      this.pause();
      this.go_to(this.#count + by);
    };
    this.element = element(
      "div",
      { class: "player" },
      element(
        "div",
        { class: "buttons" },
        this.#play,
        button(text.maze.back, step(-1), { "aria-label": text.maze.back_name }),
        button(text.maze.step, step(1), { "aria-label": text.maze.step_name }),
        button(text.maze.to_end, step(Infinity)),
      ),
      element("label", { class: "field" }, element("span", {}, text.maze.speed), this.#speed),
      element("label", { class: "field" }, this.#position, this.#slider),
      element(
        "div",
        { class: "cycle" },
        this.#input,
        element(
          "dl",
          {},
          ...[
            [text.maze.state, this.#state],
            [text.maze.input, this.#symbol],
            [text.maze.move, this.#move],
            [text.maze.rule, this.#rule],
          ].flatMap(([label, value]) => [element("dt", {}, label as string), value as HTMLElement]),
        ),
      ),
      element("h3", {}, text.maze.stack),
      this.#stack,
      this.#figures,
    );
    addEventListener("aisle-theme", () => this.#show_cycle());
  }

  load(run: MazeRun | undefined): void {
    this.pause();
    this.#run = run;
    this.#count = 0;
    this.element.hidden = run === undefined;
    if (!run) return;
    this.#slider.max = String(run.steps.length);
    const { visited, reachable, moves, complete } = run.figures;
    const outcome = complete ? text.maze.complete : text.maze.incomplete;
    set_text(this.#figures, text.maze.figures(outcome, visited, reachable, moves));
    this.go_to(1);
  }

  go_to(count: number): void {
    if (!this.#run) return;
    this.#count = Math.min(this.#run.steps.length, Math.max(1, count));
    this.#slider.value = String(this.#count);
    this.#show_cycle();
    this.show(this.#count);
  }

  play(): void {
    if (!this.#run) return;
    if (this.#count === this.#run.steps.length) this.go_to(1);
    set_text(this.#play, text.maze.pause);
    this.#advance();
  }

  pause(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    set_text(this.#play, text.maze.run);
  }

  #toggle(): void {
    if (this.#timer === undefined) this.play();
    else this.pause();
  }

  /** From one to some hundred cycles per second: several per frame if the screen is slower. */
  #advance(): void {
    const cycles_per_s = 10 ** (Number(this.#speed.value) / 40);
    const wait_ms = Math.max(16, 1000 / cycles_per_s);
    this.#timer = setTimeout(() => {
      this.go_to(this.#count + Math.max(1, Math.round((cycles_per_s * wait_ms) / 1000)));
      if (this.#count === this.#run?.steps.length) this.pause();
      else this.#advance();
    }, wait_ms);
  }

  #show_cycle(): void {
    const step = this.#run?.steps[this.#count - 1];
    if (!this.#run || !step) return;
    set_text(this.#position, `${this.#count} of ${this.#run.steps.length}`);
    set_text(this.#state, step.state);
    set_text(this.#symbol, `${step.input}, ${step.input_kind}`);
    set_text(this.#move, text.maze.directions[step.move]);
    set_text(this.#rule, step.rule);
    const top = step.stack.slice(-stack_shown).toReversed();
    const more = step.stack.length - top.length;
    if (more > 0) top.push(text.maze.more(more));
    this.#stack.replaceChildren(...top.map((symbol) => element("li", {}, symbol)));
    const context = this.#input.getContext("2d");
    if (context)
      draw_input(
        context,
        input_px,
        step.open,
        false_walls(step, known_after(this.#run, this.#count).came_from),
      );
    this.#input.setAttribute("aria-label", text.maze.open_sides(step.open));
  }
}
