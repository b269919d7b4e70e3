/* How it is measured. */
function averagesSay() {
  const averaged = report.reference.signals.concat(...report.runs.map(r => r.signals)).filter(s => s.averaged_over > 0);
  const names = [...new Set(averaged.map(s => `${s.signal} over ${g(s.averaged_over)} √(H/g)`))];
  return names.length ? `Averages in time: pressures at ${names.join(', ')}. Every number of these signals, of runs, reference and experiments alike, is that of the running mean centred on each instant, the exact integral of the signal as it is interpolated, over less where the signal ends.` : null;
}

const FILTERS_SAY = 'Filters are of the raw signals of probes, and beside them only. Low pass: the signal, put on even instants where it is not, is a sum of cosines over its duration (its even continuation has no jump at the ends); those of its period are halved, of 2/3 of it and less gone, of twice it and more left. The mean of the whole stays, and with it the impulse over it; about a sudden rise the rest overshoots by up to a tenth. Mean over a length of the wall: each probe on it stands for the stretch that is nearest to it. Impulse: trapezoids from the first row on.';
const SPECTRA_SAY = "Spectra are of raw series: the longest stretch of rows without a gap, less its mean, times a Hann window. Amplitude: that of a sine at the bin. Power density: adds up to the mean square. A peak's frequency and amplitude are those of the sine that the two highest bins are of, between them too; peaks below a twentieth of the highest are left out. A figure has the highest of bins that are closer than 0.2 %.";

function scalesSay() {
  const s = report.scales;
  return [`Scales: lengths in H = ${g(s.H_m)} m, times t* in √(H/g) = ${g(s.time_s)} s, pressures in ρgH = ${g(s.pressure_Pa)} Pa, energies in E0 = ${g(s.E0_J_per_m)} J/m, which is ${report.about.method.E0_is}.`,
    "Noise floor: the surface of a cloud of particles is known to about half a particle spacing, dx/2; for the area, dx/2 times the length of the reference's surface in the window. Values below it are shown in grey: they are zero as far as can be told."];
}

function surfacesSay() {
  const m = report.about.method, depth = g(report.front_depth, 3);
  return [`Main surface: pieces at least ${g(100 * m.main_surface_fraction)} % as long as the longest. Shorter ones are spray and bubbles; they count in the Hausdorff distance and in the area only.`,
    `Mean and largest distance: from points every dx/2 along one main surface, inside the window, to the whole of the other, in both directions. Films thinner than ${depth} H (two spacings of the coarsest run) on the tank's walls are left out, since no particle method resolves them: points closer than that to a wall are not taken, nor is the surface of a bed that is wet and no deeper. The Hausdorff distance and the discrete Fréchet distance (of the longest connected parts) leave out nothing.`,
    "Area: free surfaces are closed along the tank into regions of water; the area is that of their symmetric difference within the window. It is withheld when an outline encloses less or more than the run's volume by a fifth.",
    `Front: the furthest x, towards the wall that the reference's water runs to (${report.front_runs_to === 'none' ? 'here none' : `the ${report.front_runs_to}`}), at which the water standing on the bed is deeper than ${g(report.front_depth)} H (two spacings of the coarsest run), the same depth in every run, until the reference reaches that wall. None runs where the bed is wet from wall to wall at first.`];
}

function healthSay() {
  const limits = report.about.health.map(m => `${m.help} (doubtful above ${g(m.doubtful_above)}${m.failed_above === null ? '' : `, failed above ${g(m.failed_above)}`})`);
  return `Health: what a run says of itself, against limits. ${limits.join(', ')}. Nothing is compared with a reference after the instant at which its energies or volumes have failed.`;
}

function othersSay() {
  const m = report.about.method;
  return [`Jet: where the longest piece turns back by more than ${g(m.jet_least_overhang)} H (three spacings of the coarsest run), films on walls left out. The tip is where the surface turns most sharply around water (points 0.2 H before and after it along the surface are closest); the direction runs to it from the middle of the section 0.2 H behind; thickness is the distance between the points where circles about the tip cut its two sides; the cavity is closed by the vertical through the tip. Direction is counted counter-clockwise from +x.`,
    `Signals are compared over the time both cover, interpolated linearly. Arrival: first time at ${g(m.onset)} ρgH (pressure) or ${g(m.onset)} H (height). The best shift is the one within ±${g(m.largest_shift)} √(H/g) with the smallest rms; positive: the run is late. It is never applied.`,
    averagesSay(), report.reference.filters.length ? FILTERS_SAY : null, report.reference.spectra.length ? SPECTRA_SAY : null,
    "Energy: mechanical = kinetic + potential + the energy of water that a solver took out of its computation. The budget is kinetic + potential + elastic + removed + what each of the solver's own terms has taken; its closure is its change since t = 0.",
    m.window_is_whole ? null : `Window: x/H from ${g(report.window[0][0])} to ${g(report.window[1][0])}, y/H from ${g(report.window[0][1])} to ${g(report.window[1][1])}.`];
}

function method() {
  const says = [...scalesSay(), ...surfacesSay(), healthSay(), ...othersSay()].filter(s => s);
  const licence = byId('licence').textContent.trim();
  return [make('ul', {}, says.map(s => make('li', {}, s))), h3('The measures that compare.tolerances may name'),
    make('dl', {}, report.about.measures.flatMap(m => [make('dt', {}, `${m.name} [${m.units}]`), make('dd', {}, m.help)])),
    licence ? make('details', {}, make('summary', {}, `Charts are drawn by D3 ${window.d3 ? window.d3.version : ''}; its licence`), make('pre', {tabindex: 0}, licence)) : null];
}
