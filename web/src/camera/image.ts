import type { CompressedImage, Header, Image } from "../connection/messages";

export interface CameraImage {
  source: CanvasImageSource;
  width: number;
  height: number;
  stamp_s: number;
}

function seconds({ stamp }: Header): number {
  return stamp.sec + stamp.nanosec / 1e9;
}

export async function decode_compressed({ header, format, data }: CompressedImage): Promise<CameraImage> {
  const type = format.includes("png") ? "image/png" : "image/jpeg";
  const source = await createImageBitmap(new Blob([data as Uint8Array<ArrayBuffer>], { type }));
  return { source, width: source.width, height: source.height, stamp_s: seconds(header) };
}

/** RGBA pixels for a canvas, from `mono8` or `rgb8`. */
export function rgba_of({
  width,
  height,
  encoding,
  step,
  data,
}: Omit<Image, "header">): Uint8ClampedArray<ArrayBuffer> {
  if (encoding !== "mono8" && encoding !== "rgb8") throw new Error(`unknown pixel format: ${encoding}`);
  const [size, green, blue] = encoding === "mono8" ? [1, 0, 0] : [3, 1, 2];
  const rgba = new Uint8ClampedArray(width * height * 4).fill(255);
  for (let v = 0; v < height; v += 1) {
    for (let u = 0; u < width; u += 1) {
      const from = v * step + u * size;
      const to = (v * width + u) * 4;
      rgba[to] = data[from] ?? 0;
      rgba[to + 1] = data[from + green] ?? 0;
      rgba[to + 2] = data[from + blue] ?? 0;
    }
  }
  return rgba;
}

export async function decode_raw(image: Image): Promise<CameraImage> {
  const { width, height, header } = image;
  const source = await createImageBitmap(new ImageData(rgba_of(image), width, height));
  return { source, width, height, stamp_s: seconds(header) };
}
