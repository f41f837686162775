// A browser, a folder of files to play, and lines that say what was seen. Usage of every test:
//   node NAME.mjs WRITE-PLAYER-FILES [CHROMIUM [WAVECURVE]]
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

// Everything temporary, the browser's profile too, lies in one folder that goes with the process.
export const folder = mkdtempSync(join(tmpdir(), 'wavecurve-browser-'));
process.env.TMPDIR = folder;
process.on('exit', () => rmSync(folder, { recursive: true, force: true, maxRetries: 5 }));
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(1));

const { chromium } = await import('playwright-core');
const [writer, executablePath = '/usr/bin/chromium'] = process.argv.slice(2);
execFileSync(writer, [folder]);

const flags = ['--no-sandbox', '--headless', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export const url = (name) => pathToFileURL(join(folder, name)).href;
export const read = (name) => readFileSync(join(folder, name));

let failures = 0;

/** One line for what was looked at. */
export function check(holds, what, figure = '') {
  console.log(`${holds ? 'ok    ' : 'FAILED'}  ${what}${figure === '' ? '' : `: ${figure}`}`);
  if (!holds) failures += 1;
}

/** Sets the exit code. */
export function finish() {
  process.exitCode = failures === 0 ? 0 : 1;
}

/** Runs a test with a browser, and closes it whatever happens. */
export async function withBrowser(test) {
  const browser = await chromium.launch({ executablePath, args: flags });
  try {
    await test(browser);
  } catch (error) {
    check(false, 'the test runs to its end', error.message);
  } finally {
    await browser.close();
  }
  finish();
}

/** A page of 500 x 400 pixels, the size of the reference frames; what it complains of is a failure. */
export async function openPage(browser, options = {}) {
  const page = await browser.newPage({ viewport: { width: 500, height: 400 }, ...options });
  page.on('pageerror', (error) => check(false, 'no error in the page', error.message));
  page.on('request', (request) => {
    if (!/^(file|data|blob|about):/.test(request.url())) check(false, 'no request', request.url());
  });
  return page;
}

/** Intersection over union of what two images put on white paper, over all channels: the sum of the
    lesser over the sum of the greater. 1 for equal images. */
async function overlap(browser, image, reference) {
  const page = await browser.newPage();
  const result = await page.evaluate(async (urls) => {
    const inks = await Promise.all(urls.map(async (source) => {
      const picture = new Image();
      picture.src = source;
      await picture.decode();
      const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      canvas.fillStyle = 'white';
      canvas.fillRect(0, 0, picture.width, picture.height);
      canvas.drawImage(picture, 0, 0);
      return canvas.getImageData(0, 0, picture.width, picture.height);
    }));
    const [a, b] = inks;
    if (a.width !== b.width || a.height !== b.height) {
      throw new Error(`${a.width} x ${a.height} pixels against ${b.width} x ${b.height}`);
    }
    let lesser = 0, greater = 0;
    for (let i = 0; i < a.data.length; ++i) {
      const x = 255 - a.data[i], y = 255 - b.data[i];
      lesser += Math.min(x, y);
      greater += Math.max(x, y);
    }
    return lesser / greater;
  }, [image, reference].map((bytes) => 'data:image/png;base64,' + bytes.toString('base64')));
  await page.close();
  return result;
}

/** Compares what an element (or the page) shows with a frame of the program's own raster. */
export async function compare(browser, target, reference, what) {
  const value = await overlap(browser, await target.screenshot(), read(reference));
  check(value >= 0.99, `${what} looks like ${reference}`, value.toFixed(4));
}
