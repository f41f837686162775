// The page of `wavecurve check -o` shows the rows whose verdict is ticked, on paper too, and all of
// them where no JavaScript runs. The third argument is the program.
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { check, folder, openPage, url, withBrowser } from './browser.mjs';

const table = join(folder, 't.csv');
writeFileSync(table, '# filter: D8\n# quantity: h\nindex,printed\n'
  + '0,0.23037781\n1,0.71484657\n2,0.63188077\n3,-0.02798377\n');
spawnSync(process.argv[4], ['check', table, '-o', join(folder, 'page.html')]);

const shown = (page) => page.locator('tbody tr:visible').count();

await withBrowser(async (browser) => {
  const page = await openPage(browser);
  await page.goto(url('page.html'));
  check(await shown(page) === 4, 'all rows are shown at first');
  check(await page.locator('#shown').textContent() === '', 'and nothing is said of it');
  await page.locator('input[value=certified]').uncheck();
  check(await shown(page) === 1, 'the rows of one verdict are hidden');
  check(await page.locator('#shown').textContent() === '; 1 of 4 rows shown', 'their number is told');
  check(await page.locator('mark').textContent() === '1', 'the departing digit is marked');
  await page.emulateMedia({ media: 'print' });
  check(await shown(page) === 1, 'paper has the rows that were chosen');
  check(!await page.locator('input').first().isVisible(), 'and nothing to tick');
  await page.close();

  const still = await openPage(browser, { javaScriptEnabled: false });
  await still.goto(url('page.html'));
  check(await shown(still) === 4, 'without JavaScript all rows are shown');
  check(await still.locator('input').first().isDisabled(), 'and nothing can be ticked');
});
