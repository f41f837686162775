// The player page: what a viewer does with mouse and keyboard, and what is then to be seen.
import { check, compare, openPage, url, withBrowser } from './browser.mjs';

const still = { reducedMotion: 'reduce' };

/** The time shown, 0 .. 1. */
const tau = (page) => page.locator('#time').evaluate((slider) => Number(slider.value));
const near = (value, expected) => Math.abs(value - expected) < 1e-6;
const playing = async (page) =>
  await page.locator('#play').getAttribute('aria-label') === 'Pause';

/** Moves a slider to a value as a drag does. */
const slide = (page, id, value) => page.locator(id).evaluate((slider, to) => {
  slider.value = to;
  slider.dispatchEvent(new Event('input', { bubbles: true }));
}, value);

/** Compares the stage, alone and in the size of the reference frames. */
async function compareStage(browser, page, reference, what) {
  const style = await page.addStyleTag({ content:
    '#stage { position: fixed; inset: 0; width: 500px; height: 400px; border: 0; ' +
    'border-radius: 0; z-index: 9; background: white; }' });
  await compare(browser, page, reference, what);
  await style.evaluate((element) => element.remove());
}

async function playAndPause(page, name) {
  check(!await playing(page), `${name} stands still where less motion is preferred`);
  await page.locator('#play').click();
  await page.waitForFunction(() => document.getElementById('time').value > 0.05)
    .catch(() => {});  // the line below tells
  const moved = await tau(page);
  check(moved > 0 && await playing(page), `${name}: a click on play moves it`, moved.toFixed(3));
  await page.locator('#play').click();
  const stopped = await tau(page);
  await page.waitForTimeout(200);
  check(await tau(page) === stopped && !await playing(page), `${name}: a second click stops it`);
}

async function keyboard(page, name) {
  await page.locator('h1').click();
  await page.keyboard.press('Home');
  check(near(await tau(page), 0), `${name}: Home shows the first frame`);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  check(near(await tau(page), 2 / 60), `${name}: an arrow goes a frame on`);
  await page.keyboard.press('ArrowLeft');
  check(near(await tau(page), 1 / 60), `${name}: an arrow goes a frame back`);
  await page.keyboard.press('Shift+ArrowRight');
  check(near(await tau(page), 11 / 60), `${name}: with Shift it goes ten`);
  await page.keyboard.press('End');
  check(near(await tau(page), 1), `${name}: End shows the last frame`);
  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => document.getElementById('time').value > 0.01).catch(() => {});
  check(await playing(page) && await tau(page) > 0, `${name}: Space plays`);
  await page.keyboard.press(' ');
  check(!await playing(page), `${name}: Space stops`);
  await page.locator('#play').focus();
  await page.keyboard.press(' ');
  check(await playing(page), `${name}: Space on the button counts once`);
  await page.keyboard.press(' ');
}

async function scrub(browser, page, name, reference) {
  for (let quarter = 0; quarter <= 4; ++quarter) {
    await slide(page, '#time', quarter / 4);
    await compareStage(browser, page, `${reference}-${quarter}.png`,
      `${name} scrubbed to ${quarter / 4}`);
  }
}

async function accessibility(page, name) {
  const unnamed = await page.evaluate(() => [...document.querySelectorAll('button, input, select')]
    .filter((control) => !control.ariaLabel && !control.labels.length).length);
  check(unnamed === 0, `${name}: every control has a name`);
}

async function scale(browser, page) {
  await slide(page, '#time', 0.25);
  await page.locator('#detail').selectOption('drop');
  await slide(page, '#scale', 6);
  check(await page.locator('#control-points').textContent() === '64', 'the slider chooses 64 points');
  await scrub(browser, page, 'morph.html, 64 points, details dropped', 'drop-64');
  await page.locator('#detail').selectOption('stage');
  await scrub(browser, page, 'morph.html, 64 points, details in stages', 'stage-64');
  await page.locator('h1').click();
  await page.keyboard.press('ArrowDown');
  check(await page.locator('#control-points').textContent() === '32', 'the arrow down halves them');
  for (let i = 0; i < 9; ++i) await page.keyboard.press('ArrowUp');
  check(await page.locator('#control-points').textContent() === '256', 'there are at most 256');
}

await withBrowser(async (browser) => {
  for (const [name, reference] of [['polygons.html', 'animation'], ['cubics.html', 'animation'],
    ['morph.html', 'blend']]) {
    const page = await openPage(browser, still);
    await page.goto(url(name));
    await playAndPause(page, name);
    await keyboard(page, name);
    await accessibility(page, name);
    await scrub(browser, page, name, reference);
    if (name === 'morph.html') await scale(browser, page);
    const choosers = await page.locator('#scale:visible').count();
    check(choosers === (name === 'morph.html' ? 1 : 0), `${name}: a scale where there is one to choose`);
    await page.close();
  }
  const page = await openPage(browser, { viewport: { width: 390, height: 700 } });
  await page.goto(url('morph.html'));
  await page.waitForTimeout(200);
  check(await playing(page), 'the page plays by itself where motion is welcome');
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  check(overflow <= 0, 'nothing overflows on a narrow screen', `${overflow} px`);
});
