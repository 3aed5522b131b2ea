// SPDX-License-Identifier: MIT
// What a person does at the table, played in a real browser against the built page. Run by `node --test`, one after the
// other in one browser.
import './drawing.mjs';
import './body.mjs';
import './files.mjs';
import './visits.mjs';
import './page.mjs';
