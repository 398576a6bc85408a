// Prints every pair of a folder of token files with its likeness, as Dolos has it.
import { readFileSync, readdirSync } from "node:fs";
import { File, FingerprintIndex, Region, TokenizedFile } from "MODULES/@dodona/dolos-core/dist/index.js";

function read(folder, name) {
  const text = readFileSync(`${folder}/program.txt`, "utf8");
  const tokens = text.split(" ").map((token) => token.trim());
  const places = tokens.map((_, k) => new Region(0, k, 0, k + 1));
  return new TokenizedFile(new File(name, text), tokens, places);
}

const [files, given] = process.argv.slice(2);
const index = new FingerprintIndex(12, 6); // Dolos' 23 and 17 are for the nodes of syntax trees
index.addIgnoredFile(read(given, "given"));
index.addFiles(readdirSync(files).map((name) => read(`${files}/${name}`, name)));
const pairs = index.allPairs("similarity").map((pair) => [
  pair.leftFile.path,
  pair.rightFile.path,
  pair.similarity,
]);
process.stdout.write(JSON.stringify(pairs));
