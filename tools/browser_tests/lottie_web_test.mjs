// lottie-web plays what we write, and shows what our own raster shows.
import { createRequire } from 'node:module';
import { check, compare, openPage, read, withBrowser } from './browser.mjs';

const library = createRequire(import.meta.url).resolve('lottie-web/build/player/lottie_svg.min.js');

await withBrowser(async (browser) => {
  for (const name of ['polygons.json', 'cubics.json']) {
    const page = await openPage(browser);
    await page.setContent('<body style="margin:0"><div id="box" style="width:500px;height:400px">');
    await page.addScriptTag({ path: library });
    await page.evaluate((animationData) => {
      window.animation = lottie.loadAnimation({
        container: document.getElementById('box'), renderer: 'svg', loop: true, autoplay: true,
        animationData,
      });
    }, JSON.parse(read(name)));
    await page.waitForFunction(() => window.animation.isLoaded);
    const frame = () => page.evaluate(() => window.animation.currentFrame);
    const before = await frame();
    await page.waitForFunction((first) => window.animation.currentFrame !== first, before)
      .catch(() => {});
    const after = await frame();
    check(before !== after, `${name} plays`, `frame ${before.toFixed(1)} -> ${after.toFixed(1)}`);
    for (let quarter = 0; quarter <= 4; ++quarter) {
      await page.evaluate((at) => window.animation.goToAndStop(at, true), 15 * quarter);
      await compare(browser, page, `animation-${quarter}.png`, `${name}, frame ${15 * quarter}`);
    }
    await page.close();
  }
});
