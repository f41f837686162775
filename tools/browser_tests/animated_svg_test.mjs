// The moving SVG moves in Chromium, and looks as our own raster does, also between its keys.
import { check, compare, openPage, url, withBrowser } from './browser.mjs';

await withBrowser(async (browser) => {
  for (const name of ['polygons', 'cubics']) {
    const page = await openPage(browser);
    await page.goto(url(`${name}.svg`));
    const width = () => page.evaluate(() => document.querySelector('path').getBBox().width);
    const before = await width();
    await page.waitForFunction((first) =>
      document.querySelector('path').getBBox().width !== first, before).catch(() => {});
    const after = await width();
    check(before !== after, `${name}.svg moves by itself`, `${before} -> ${after}`);
    for (let quarter = 0; quarter < 4; ++quarter) {
      await page.evaluate((time) => {
        document.documentElement.pauseAnimations();
        document.documentElement.setCurrentTime(time);
      }, quarter / 2);
      await compare(browser, page, `animation-${quarter}.png`, `${name}.svg at ${quarter / 2} s`);
    }
    // An animation that loops is at its end only for a limit of times.
    await page.evaluate(() => document.documentElement.setCurrentTime(2 - 1e-6));
    await compare(browser, page, 'animation-4.png', `${name}.svg just before 2 s`);
    await page.close();
  }
});
