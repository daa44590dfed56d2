import type { App } from "../page/app";
import { element, select } from "../page/element";
import { Sheet } from "../page/sheet";
import { colour } from "../page/theme";
import { draw_caption } from "../plan/draw";
import { text } from "../text";
import { ValueHistory, range_of } from "./value_history";
import type { ValueName } from "./value_history";

const shown_s = 60;
const margin_px = 4;
const names = Object.keys(text.plot.values) as ValueName[];
const choices = names.map((value) => ({ value, label: text.plot.values[value] }));

/** Two values over the last minute, each in a scale of its own. */
export function plot(app: App): HTMLElement {
  const canvas = element("canvas", { role: "img", "aria-label": text.plot.name });
  const history = new ValueHistory(app.connection, () => {
    if (canvas.offsetParent !== null) sheet.redraw();
  });
  const chosen: [ValueName, ValueName] = ["speed", "command"];

  const draw_value = (context: CanvasRenderingContext2D, name: ValueName, stroke: string, end_s: number) => {
    const samples = history.of(name).filter(({ stamp_s }) => stamp_s >= end_s - shown_s);
    if (samples.length === 0) return undefined;
    const { low, high } = range_of(samples);
    const [width, height] = [sheet.width_px - 2 * margin_px, sheet.height_px - 2 * margin_px];
    context.strokeStyle = stroke;
    context.lineWidth = 1.5;
    context.beginPath();
    for (const { stamp_s, value } of samples)
      context.lineTo(
        margin_px + width * (1 - (end_s - stamp_s) / shown_s),
        margin_px + height * (1 - (value - low) / (high - low)),
      );
    context.stroke();
    return { low, high };
  };
  const sheet = new Sheet(canvas, (context) => {
    const end_s = Math.max(0, ...chosen.map((name) => history.of(name).at(-1)?.stamp_s ?? 0));
    chosen.forEach((name, index) => {
      const range = draw_value(context, name, colour(index === 0 ? "accent" : "path"), end_s);
      if (!range) return;
      context.textAlign = index === 0 ? "left" : "right";
      const x = index === 0 ? margin_px : sheet.width_px - margin_px;
      draw_caption(context, { x, y: 12 }, range.high.toPrecision(3));
      draw_caption(context, { x, y: sheet.height_px - 10 }, range.low.toPrecision(3));
    });
  });
  const choosers = [text.plot.first, text.plot.second].map((label, index) => {
    const { field, list } = select(label, choices, (value) => {
      chosen[index as 0 | 1] = value as ValueName;
      sheet.redraw();
    });
    list.value = chosen[index as 0 | 1];
    field.classList.add(index === 0 ? "first-value" : "second-value");
    return field;
  });
  return element("div", { class: "plot" }, canvas, ...choosers);
}
