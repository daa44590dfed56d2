/**
 * A canvas drawn in CSS pixels: redrawn at most once a frame, on request and when its size or the colours of the page
 * change.
 */
export class Sheet {
  width_px = 1;
  height_px = 1;
  #is_due = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly draw: (context: CanvasRenderingContext2D) => void,
  ) {
    new ResizeObserver(() => this.#resize()).observe(canvas);
    addEventListener("aisle-theme", () => this.redraw());
  }

  redraw(): void {
    if (this.#is_due) return;
    this.#is_due = true;
    requestAnimationFrame(() => {
      this.#is_due = false;
      this.#draw();
    });
  }

  #draw(): void {
    const context = this.canvas.getContext("2d");
    if (!context || this.width_px < 2) return;
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, this.width_px, this.height_px);
    this.draw(context);
  }

  #resize(): void {
    this.width_px = this.canvas.clientWidth;
    this.height_px = this.canvas.clientHeight;
    this.canvas.width = Math.round(this.width_px * devicePixelRatio);
    this.canvas.height = Math.round(this.height_px * devicePixelRatio);
    this.redraw();
  }
}
