import type { LiveConnection } from "../connection/live_connection";
import { json_of } from "../connection/live_state";
import type { CompressedImage, Image } from "../connection/messages";
import { Age } from "../page/age";
import { text } from "../text";
import { element, set_text, select, tick } from "../page/element";
import { colour_of, draw_overlay, kinds_of } from "./overlay";
import type { Overlay } from "./overlay";
import { decode_compressed, decode_raw } from "./image";
import type { CameraImage } from "./image";

/** Cameras that look ahead are listed first. */
const ahead = ["corridor", "front"];

const topic_form = /^\/camera\/([^/]+)\/image_raw(\/compressed)?$/;

/** A camera's newest image, overlaid with what the navigator detected in it. */
export class CameraView {
  readonly element: HTMLElement;
  readonly #canvas = element("canvas", { role: "img", "aria-label": text.camera.image });
  readonly #empty = element("p", { class: "empty" }, text.camera.none);
  readonly #old = element("p", { class: "age", hidden: true });
  readonly #age: Age;
  readonly #toggles = element("div", { class: "toggles", role: "group", "aria-label": "Lines" });
  readonly #chooser = select(text.camera.chooser, [], (name) => {
    this.#is_picked = true;
    this.#choose(name);
  });
  readonly #hidden = new Set<string>();
  readonly #known_kinds = new Set<string>();
  #camera = "";
  /** The user chose the camera. */
  #is_picked = false;
  #ends: (() => void)[] = [];
  #image: CameraImage | undefined;
  #overlay: Overlay | undefined;
  #is_decoding = false;
  #waiting: (() => Promise<CameraImage>) | undefined;

  /** @param stands whether an image stays true without newer ones, as in a replay that is paused */
  constructor(
    private readonly connection: LiveConnection,
    stands: () => boolean,
  ) {
    this.#chooser.field.hidden = true;
    const frame = element("div", { class: "camera-image" }, this.#canvas, this.#empty, this.#old);
    frame.addEventListener("dblclick", () => {
      if (document.fullscreenElement) void document.exitFullscreen();
      else void frame.requestFullscreen();
    });
    this.#age = new Age(frame, this.#old, stands, text.camera.old);
    this.element = element(
      "div",
      { class: "camera" },
      frame,
      element("div", { class: "camera-bar" }, this.#chooser.field, this.#toggles),
    );
    connection.channels.watch(() => this.#offer_cameras());
  }

  #offer_cameras(): void {
    const names = this.connection.topics().flatMap(({ topic }) => topic_form.exec(topic)?.[1] ?? []);
    const rank = (name: string) => (ahead.includes(name) ? 0 : 1);
    const offered = [...new Set(names)].sort((a, b) => rank(a) - rank(b) || a.localeCompare(b));
    const shown = [...this.#chooser.list.options].map(({ value }) => value);
    if (offered.length === 0 || offered.join() === shown.join()) return;
    this.#chooser.list.replaceChildren(...offered.map((name) => element("option", { value: name }, name)));
    this.#chooser.field.hidden = offered.length < 2;
    this.#choose(this.#is_picked && offered.includes(this.#camera) ? this.#camera : (offered[0] ?? ""));
  }

  #choose(name: string): void {
    this.#chooser.list.value = name;
    if (name === this.#camera) return;
    for (const end of this.#ends) end();
    this.#camera = name;
    this.#image = undefined;
    this.#overlay = undefined;
    this.#age.forget();
    this.#ends = [
      this.connection.listen(`/camera/${name}/image_raw/compressed`, (message) =>
        this.#take(() => decode_compressed(message as CompressedImage)),
      ),
      this.connection.listen(`/camera/${name}/image_raw`, (message) =>
        this.#take(() => decode_raw(message as Image)),
      ),
      this.connection.listen(`/overlay/${name}`, (message) => this.#take_overlay(json_of<Overlay>(message))),
    ];
  }

  /** Decodes one image at a time, and none while hidden; of those that arrive meanwhile it keeps the newest. */
  #take(decode: () => Promise<CameraImage>): void {
    if (this.#canvas.offsetParent === null) return;
    this.#waiting = decode;
    if (!this.#is_decoding) void this.#decode_waiting();
  }

  async #decode_waiting(): Promise<void> {
    this.#is_decoding = true;
    while (this.#waiting) {
      const decode = this.#waiting;
      this.#waiting = undefined;
      try {
        this.#image = await decode();
        this.#age.renew();
        this.#draw();
      } catch {
        set_text(this.#empty, text.camera.unreadable);
        this.#empty.hidden = false;
      }
    }
    this.#is_decoding = false;
  }

  #take_overlay(overlay: Overlay): void {
    this.#overlay = overlay;
    for (const kind of kinds_of(overlay)) this.#offer_toggle(kind);
    this.#draw();
  }

  #offer_toggle(kind: string): void {
    if (this.#known_kinds.has(kind)) return;
    this.#known_kinds.add(kind);
    const toggle = tick(kind, true, (shown) => {
      if (shown) this.#hidden.delete(kind);
      else this.#hidden.add(kind);
      this.#draw();
    });
    toggle.classList.add("line-kind");
    toggle.style.setProperty("--line-kind", `var(--${colour_of(kind)})`);
    this.#toggles.append(toggle);
  }

  #draw(): void {
    const context = this.#canvas.getContext("2d");
    if (!context || !this.#image) return;
    const { width, height, source, stamp_s } = this.#image;
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
    context.drawImage(source, 0, 0);
    if (this.#overlay) draw_overlay(context, this.#overlay, stamp_s, this.#hidden);
    this.#empty.hidden = true;
    this.#canvas.dataset["stampS"] = stamp_s.toFixed(3);
  }
}
