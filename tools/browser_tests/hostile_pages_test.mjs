// Pages and pictures that are made of hostile names hold what those of plain names hold, as a browser
// parses them, and nothing of a name runs. The third argument is the program.
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { check, folder, openPage, url, withBrowser } from './browser.mjs';

const plain = 'plain';
const hostile = [
  '<script>window.obeyed = 1</script>', '</script><script>window.obeyed = 1</script>', '-->', ']]>',
  '"><img src=x onerror="window.obeyed = 1">', "' onload='window.obeyed = 1", '<!--', '{{data}}{{title}}',
  'javascript:window.obeyed=1', '</style><svg onload=window.obeyed=1>', '</title><script>window.obeyed=1</script>',
  '&lt;script&gt;', '`${window.obeyed = 1}`', '\\u003cscript>', 'a\u2028window.obeyed = 1', '\u202eabc',
  '<svg xmlns="http://www.w3.org/2000/svg"><script>window.obeyed = 1</script></svg>',
  '<![CDATA[', '<?xml version="1.0"?>', '%3Cscript%3E', '{"a": "</script>"}', "\\';window.obeyed=1;//",
];

const attribute = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
const drawing = (name, size) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40"><path `
  + `id="${attribute(name)}" d="M0 0H${size}V${2 * size}z"/></svg>`;

/** Runs the program in the folder of the files; what it writes there is looked at. */
function run(...words) {
  const done = spawnSync(process.argv[4], words, { cwd: folder, encoding: 'utf8' });
  check([0, 1].includes(done.status), words.join(' ').slice(0, 70), done.status === 2 ? done.stderr : '');
}

/** Every output that a browser reads, made of one name. */
function write(name) {
  const file = name.replaceAll('/', '_').slice(0, 80);
  writeFileSync(join(folder, 'a.svg'), drawing(name, 10));
  writeFileSync(join(folder, `${file}.svg`), drawing(name, 15));
  writeFileSync(join(folder, 't.csv'), `# title: ${name}\n# filter: D8\n# quantity: h\nindex,printed,"`
    + `${name.replaceAll('"', '""')}"\n0,0.23037781,"${name.replaceAll('"', '""')}"\n`);
  for (const ending of ['html', 'svg']) {
    run('morph', '--samples', '16', '-o', `moves.${ending}`, '--', 'a.svg', `${file}.svg`);
  }
  run('check', 't.csv', '-o', 'table.html');
  run('describe', '--samples', '16', '-o', 'd.json', '--', `${file}.svg`);
  run('reconstruct', 'd.json', '-o', 'still.svg');
  return ['moves.html', 'moves.svg', 'table.html', 'still.svg'];
}

/** How many elements, scripts and handlers a browser finds. */
async function counted(page, file) {
  await page.goto(url(file));
  await page.waitForTimeout(50);
  return page.evaluate(() => {
    const all = [...document.querySelectorAll('*')];
    return JSON.stringify({
      elements: all.length,
      scripts: all.filter((element) => element.localName === 'script').length,
      handlers: all.flatMap((element) => element.getAttributeNames()).filter((name) => name.startsWith('on')).length,
      obeyed: window.obeyed ?? 0,
    });
  });
}

await withBrowser(async (browser) => {
  const page = await openPage(browser);
  page.on('dialog', (dialog) => { check(false, 'no dialog', dialog.message()); dialog.dismiss(); });
  const expected = {};
  for (const file of write(plain)) expected[file] = await counted(page, file);
  for (const name of hostile) {
    for (const file of write(name)) {
      const found = await counted(page, file);
      check(found === expected[file], `${file} of ${JSON.stringify(name)} is that of a plain name`,
        found === expected[file] ? '' : `${found}, but ${expected[file]}`);
    }
  }
});
