// The schema of the Lottie specification accepts what we write. It does not know two properties that
// players in use want: the version, and the time at which a layer starts.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import { check, finish, read } from './browser.mjs';

const require = createRequire(import.meta.url);
const { LottieValidator, get_schema_path } =
    require('@lottie-animation-community/lottie-specs/src/validator-node.js');
const { Ajv2020 } = require('ajv/dist/2020.js');
const validator = new LottieValidator(Ajv2020, JSON.parse(readFileSync(get_schema_path(), 'utf8')));
const wanted = /unknown property '(v|st)'/;

for (const name of ['polygons.json', 'cubics.json']) {
  const findings = validator.validate(read(name).toString(), true)
    .filter((finding) => finding.type !== 'warning' || !wanted.test(finding.message));
  for (const finding of findings) console.log(JSON.stringify(finding));
  check(findings.length === 0, `${name} satisfies the schema`, `${findings.length} findings`);
}
finish();
