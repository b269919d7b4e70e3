#!/usr/bin/env bash
# Checks of the gallery notice broken formulas and schemes: with a sign or a factor of the sources changed, an entry that
# came out as it is known to no longer does. Of each mutation one file is compiled anew and linked before the libraries,
# whose own object is then not taken.
source "$2/tests/cli/begin"
pretend_gnuplot
build=$(dirname "$program") source=$2
command -v ninja >/dev/null && [ -s "$build/compile_commands.json" ] && [ -s "$build/build.ninja" ] || exit 77

# entry | file compiled | file changed | what is looked for (a fixed string, once in the file) | what stands there instead
mutations() {
  cat <<'END'
P 1|theory/dispersion.c|theory/dispersion.c|-(w.viscosity + w.diffusion) / 2|-(w.viscosity - w.diffusion) / 2
T 2-4|theory/roots.c|theory/roots.c|: s / tanh(x);|: 1.01 * s / tanh(x);
T 2-20|theory/orthogonality.c|theory/orthogonality.c|return exp(-2 * m->exact.delta * z)|return exp(2 * m->exact.delta * z)
T 2-24|theory/surface.c|theory/surface.c|v.plus -= (P_b + P)|v.plus -= 1.01 * (P_b + P)
T Tab 2.1|theory/potentials.c|theory/potentials.c|((e->delta - e->nu * e->s)|((e->delta + e->nu * e->s)
T 3-1|theory/damping.c|theory/damping.c|csqrt(1 + x - 2 * p->zeta|csqrt(1 + x + 2 * p->zeta
P 4|common/flow/release_field.c|common/flow/release_field.c|(k == 2 ? 4 : 1) / 6;|(k == 2 ? 4 : 1) / 5;
T 2-17|sph/start/initial.c|sph/start/initial.c|density_of(w, p.rest, Y) * dx * dy;|density_of(w, p.rest, Y) * dx * dy * 1.1;
T 2-33|sph/time/rk.c|sph/time/rk.c|.b = {1. / 6, 1. / 3, 1. / 3, 1. / 6}};|.b = {1. / 3, 1. / 6, 1. / 6, 1. / 3}};
T 4-18|theory/smoothing.c|theory/smoothing.c|-log((2 + cos(kh)) / 3)|-log((3 + cos(kh)) / 4)
END
}

link=$(ninja -C "$build" -t commands plunge | tail -1)
[[ $link == *main.c.o* ]] || fail "no command that links the program: $link"

# The command that compiles a file of the sources, without where its object goes.
compile_command() {
  python3 - "$build/compile_commands.json" "$source/$1" <<'END'
import json, sys
for c in json.load(open(sys.argv[1])):
    if c["file"] == sys.argv[2]:
        print(c["directory"], c["command"], sep="\t")
        break
END
}

mutate() { # entry, file compiled, file changed, what, by what; leaves the program in $folder/m/plunge
  rm -rf "$folder/m" && mkdir -p "$folder/m/$(dirname "$3")" "$folder/m/$(dirname "$2")"
  python3 - "$source/$3" "$folder/m/$3" "$4" "$5" <<'END' || return 1
import sys
text = open(sys.argv[1]).read()
if text.count(sys.argv[3]) != 1:
    sys.exit(f"{sys.argv[1]} has {text.count(sys.argv[3])} times: {sys.argv[3]}")
open(sys.argv[2], "w").write(text.replace(sys.argv[3], sys.argv[4]))
END
  [ -e "$folder/m/$2" ] || cp "$source/$2" "$folder/m/$2"
  local where command
  IFS=$'\t' read -r where command < <(compile_command "$2")
  [ "$command" ] || return 1
  command=${command%% -o *}
  (cd "$where" && sh -c "$command -iquote '$folder/m' -o '$folder/m/mutant.o' -c '$folder/m/$2'") || return 1
  (cd "$build" && sh -c "$(sed "s| -o plunge | -o '$folder/m/plunge' |; s|main.c.o|& '$folder/m/mutant.o'|" <<<"$link")")
}

while IFS='|' read -r entry compiled changed what by; do
  "$program" gallery "$entry" --quick --out sound --quiet >log 2>err || fail "$entry as it is: $? $(cat log err)"
  mutate "$entry" "$compiled" "$changed" "$what" "$by" 2>err || { fail "$entry: $by: $(tail -3 err)"; continue; }
  got=0
  "$folder/m/plunge" gallery "$entry" --quick --out broken --force --quiet >log 2>err || got=$?
  [ $got = 1 ] || fail "$entry does not notice $by: $got $(cat log err)"
  echo "$entry: $changed, $by: $(grep -c '^           ' log) checks changed"
done < <(mutations)
exit $failed
