import type { GoalRequest } from "../connection/live_state";
import type { App } from "../page/app";
import { draw_goal } from "../plan/draw";
import type { Point } from "../plan/geometry";
import type { Layer } from "../plan/plan_canvas";

/** The goals that the mission which runs has not reached, with their numbers. */
export function goals_layer(app: App): Layer {
  const at = (goal: GoalRequest): (Point & { heading_deg?: number }) | undefined => {
    if ("x_m" in goal) return { ...goal, x: goal.x_m, y: goal.y_m };
    return app.plan.places().find(({ name }) => name === goal.place);
  };
  return (context, view) => {
    (app.state.value?.goals ?? []).forEach((goal, index) => {
      const place = index < (app.state.value?.goals_reached ?? 0) ? undefined : at(goal);
      if (place) draw_goal(context, view, place, String(index + 1));
    });
  };
}
