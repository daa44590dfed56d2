import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { defineConfig } from "vite";

/** Puts a compressed copy beside every file: aisle serves it, and compresses nothing itself. */
const compressed_copies = {
  name: "compressed-copies",
  writeBundle({ dir }) {
    for (const file of readdirSync(dir, { recursive: true, withFileTypes: true })) {
      const path = join(file.parentPath ?? file.path, file.name);
      if (file.isFile()) writeFileSync(`${path}.gz`, gzipSync(readFileSync(path), { level: 9 }));
    }
  },
};

/** The licences of the libraries in the page, which ask that their text goes along. */
const licences = {
  name: "licences",
  generateBundle(_, bundle) {
    const modules = Object.values(bundle).flatMap((chunk) => Object.keys(chunk.modules ?? {}));
    const packages = new Set(
      modules.flatMap((id) => /[^\0]*\/node_modules\/(@[^/]+\/)?[^/]+/.exec(id)?.[0] ?? []),
    );
    const texts = [...packages].sort().map((folder) => {
      const { name, version, license, author, homepage } = JSON.parse(
        readFileSync(join(folder, "package.json"), "utf8"),
      );
      const file = readdirSync(folder).find((name) => /^licen[cs]e/i.test(name));
      const text = file
        ? readFileSync(join(folder, file), "utf8")
        : `${author?.name ?? author}, ${homepage}\n`;
      return `== ${name} ${version}: ${license}\n\n${text}`;
    });
    this.emitFile({ type: "asset", fileName: "licences.txt", source: texts.join("\n") });
  },
};

export default defineConfig({
  base: "./",
  build: { target: "es2022", modulePreload: { polyfill: false } },
  plugins: [licences, compressed_copies],
});
