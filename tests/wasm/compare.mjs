// `node tests/wasm/compare.mjs WASM PROGRAM`: scenes that ran in WebAssembly have the rows of the native program, to 1e-12 of each
// column's largest value. On the portable path both round alike but for the functions of the mathematical library.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'

const TOLERANCE = 1e-12
const [wasm, program] = process.argv.slice(2).map(path => resolve(path))
const { instance } = await WebAssembly.instantiate(readFileSync(wasm), {})
const { run, text, memory } = instance.exports

function table(csv) {
  const [head, ...rows] = csv.trim().split('\n').map(line => line.split(','))
  return { head, rows: rows.map(row => row.map(Number)) }
}

let compared = 0
for (let scene = 0; ; scene++) {
  const length = run(scene)
  if (length === 0) break
  const answer = new TextDecoder().decode(new Uint8Array(memory.buffer, text(), length))
  if (answer.startsWith('error: ')) throw new Error(answer)
  const cut = answer.indexOf('\n')
  const folder = mkdtempSync(join(tmpdir(), 'ancf-wasm-'))
  writeFileSync(join(folder, 'scene.json'), answer.slice(0, cut))
  execFileSync(program, ['run', 'scene.json'], { cwd: folder, env: { ...process.env, ANCF_PORTABLE: '1' } })
  const native = table(readFileSync(join(folder, 'out', 'trajectory.csv'), 'utf8'))
  rmSync(folder, { recursive: true })
  const own = table(answer.slice(cut + 1))
  if (own.head.join() !== native.head.join() || own.rows.length !== native.rows.length) throw new Error('other rows or columns')
  let worst = 0
  native.head.forEach((_, column) => {
    const largest = Math.max(...native.rows.map(row => Math.abs(row[column])))
    own.rows.forEach((row, n) => {
      const apart = Math.abs(row[column] - native.rows[n][column])
      if (!(apart <= TOLERANCE * largest)) throw new Error(`${native.head[column]}: ${row[column]}, native ${native.rows[n][column]}`)
      if (largest > 0) worst = Math.max(worst, apart / largest)
    })
  })
  const { title, time } = JSON.parse(answer.slice(0, cut))
  console.log(`${title} ("${time.method}"): ${own.rows.length} rows, ${native.head.length} columns, at most ${worst.toExponential(1)} apart`)
  compared++
}
if (compared < 5) throw new Error(`only ${compared} scenes`)
console.log(`${compared} passed, 0 failed`)
