import type { App } from "../page/app";
import { get_json } from "../page/server_files";
import { keep_fresh } from "../page/server_list";
import { Signal } from "../page/signal";
import { building_of } from "./building_file";
import type { Building, BuildingFile } from "./building_file";

/** The buildings stored on the server, and the chosen one. */
export class BuildingStore {
  readonly names = new Signal<string[]>([]);
  readonly chosen = new Signal("");
  readonly building = new Signal<Building | undefined>(undefined);
  /** Whether plans show the chosen building instead of the vehicle's map. */
  readonly is_shown = new Signal(false);

  /** Whether a drag on them gives a goal with its heading. */
  readonly takes_goals = new Signal(false);

  constructor(private readonly app: App) {
    keep_fresh(app, "building", () => this.refresh());
  }

  async refresh(): Promise<void> {
    if (!this.app.connection.services.value.has("buildings/list")) return;
    const { buildings } = await this.app.connection.call<{ buildings: { name: string }[] }>("buildings/list");
    const names = buildings.map(({ name }) => name).sort();
    if (names.join("\n") !== this.names.value.join("\n")) this.names.value = names;
    if (!names.includes(this.chosen.value)) await this.choose(names[0] ?? "");
  }

  async choose(name: string): Promise<void> {
    this.chosen.value = name;
    this.building.value = undefined;
    if (name === "") return;
    const file = await get_json<BuildingFile>(`buildings/${encodeURIComponent(name)}.json`);
    if (this.chosen.value === name) this.building.value = building_of(file);
  }
}
