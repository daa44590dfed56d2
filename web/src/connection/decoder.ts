import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import type { Channel } from "@foxglove/ws-protocol";

export type Decode = (data: ArrayBufferView) => unknown;

/** Decodes a channel's messages by the schema that the server advertised. */
export function decoder_of(channel: Channel): Decode {
  if (channel.encoding === "json") {
    const text = new TextDecoder();
    return (data) => JSON.parse(text.decode(data)) as unknown;
  }
  if (channel.encoding !== "cdr") throw new Error(`${channel.topic}: unknown encoding ${channel.encoding}`);
  const reader = new MessageReader(parse(channel.schema, { ros2: true }));
  return (data) => reader.readMessage(data);
}
