const byId = id => document.getElementById(id);
const root = document.documentElement;

const theme = byId('theme'), dark = matchMedia('(prefers-color-scheme: dark)');
const isDark = () => root.dataset.theme ? root.dataset.theme === 'dark' : dark.matches;
const showTheme = () => theme.setAttribute('aria-pressed', String(isDark()));
theme.onclick = () => { root.dataset.theme = isDark() ? 'light' : 'dark'; showTheme(); };
dark.onchange = showTheme;
showTheme();

/* Cards and entries that the choices leave, and groups of which any is left. */
const of = byId('of'), verdict = byId('verdict'), words = byId('words');
const items = [...document.querySelectorAll('[data-verdict]')];
const sections = [...document.querySelectorAll('section[data-group]')];
const text = new Map(items.map(e => [e, e.textContent.toLowerCase()]));
const entry = e => e.dataset.entry ? byId(e.dataset.entry) : e; /* a card goes with its entry */
const sieve = () => {
  const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = e => (!of.value || e.dataset.group === of.value) && (!verdict.value || e.dataset.verdict === verdict.value) &&
    wanted.every(w => text.get(entry(e)).includes(w));
  items.forEach(e => { e.hidden = !fits(e); });
  sections.forEach(s => { s.hidden = ![...s.querySelectorAll('[data-verdict]')].some(e => !e.hidden); });
  const shown = items.filter(e => e.dataset.entry && !e.hidden).length, all = items.filter(e => e.dataset.entry).length;
  byId('count').textContent = shown === all ? `${all} entries` : `${shown} of ${all} entries`;
};
of.onchange = verdict.onchange = words.oninput = sieve;
document.querySelectorAll('.tally [data-of]').forEach(chip => {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = chip.className;
  button.textContent = chip.textContent;
  button.onclick = () => { verdict.value = verdict.value === chip.dataset.of ? '' : chip.dataset.of; sieve(); };
  chip.replaceWith(button);
});

/* A link to an entry that is hidden shows it. */
addEventListener('hashchange', () => {
  const to = byId(decodeURIComponent(location.hash.slice(1)));
  if (!to || !to.closest('[hidden]')) return;
  of.value = verdict.value = words.value = '';
  sieve();
  to.scrollIntoView();
});
byId('switches').hidden = byId('sieve').hidden = false;
sieve();
root.dataset.ready = 'yes';
