// SPDX-License-Identifier: GPL-3.0-or-later
// How long polars or DuckDB take to read a CSV file, in milliseconds, the best of the rounds:
//     node csv_peers.mjs polars|duckdb FOLDER FILE ROUNDS
// FOLDER is where `npm install nodejs-polars @duckdb/node-api` was run. Both use all processors, and
// only read: no grid is verified.
import {createRequire} from "node:module";
import fs from "node:fs";
import path from "node:path";
import process from "node:process";

const [peer, folder, file, rounds] = process.argv.slice(2);
const load = createRequire(path.join(path.resolve(folder), "package.json"));

async function best(read) {
    let shortest = Infinity;
    for (let round = 0; round < Number(rounds); ++round) {
        const begin = process.hrtime.bigint();
        await read();
        shortest = Math.min(shortest, Number(process.hrtime.bigint() - begin) / 1e6);
    }
    console.log(shortest.toFixed(2));
}

const beginning = fs.readFileSync(file, {encoding: "utf8"}).slice(0, 1000).split("\n");
const comments = beginning[0].startsWith("//") ? 1 : 0;

if (peer === "polars") {
    const polars = load("nodejs-polars");
    await best(() => polars.readCSV(file, {skipRows: comments, inferSchemaLength: 10000}));
} else {
    const {DuckDBInstance} = load("@duckdb/node-api");
    const connection = await (await DuckDBInstance.create(":memory:")).connect();
    const names = "{" + beginning[comments].split(",").map((_, n) => `'c${n}':'DOUBLE'`) + "}";
    await best(() => connection.run("create or replace temp table read as select * from "
        + `read_csv('${file}', skip=${comments + 1}, header=false, columns=${names})`));
}
