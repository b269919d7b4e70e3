#!/usr/bin/env bash
# The architecture's rules hold: who includes whom, what names a library exports, how long a file is.
program=$1 source=$2
build=$(dirname "$program")
cd "$source" || exit 1
failed=0
complain() {
  echo "$1"
  failed=1
}

forbidden() { # folder, what it must not include
  grep -nE "#include \"($2)/" -r "$1" && complain "$1/ includes what docs/architecture.md forbids"
}
forbidden common 'sph|bem|exact|theory|compare|gallery|import|cli'
forbidden common/base 'common/(tank|cloud|case|flow|result)'
forbidden common/tank 'common/(cloud|case|flow|result)'
forbidden common/cloud 'common/(case|flow|result)'
forbidden common/case 'common/result'
forbidden common/flow 'common/result'
forbidden sph 'bem|exact|theory|compare|gallery|import|cli'
forbidden bem 'sph|exact|theory|compare|gallery|import|cli'
forbidden bem/map 'bem/(shape|kernel|motion|water|start|breaking|run)'
forbidden bem/shape 'bem/(kernel|motion|water|start|breaking|run)'
forbidden bem/kernel 'bem/(motion|water|start|breaking|run)'
forbidden bem/motion 'bem/(water|start|breaking|run)'
forbidden bem/water 'bem/(start|breaking|run)'
forbidden bem/start 'bem/(breaking|run)'
forbidden bem/breaking 'bem/run'
forbidden exact 'sph|bem|theory|compare|gallery|import|cli'
forbidden import 'sph|bem|exact|theory|compare|gallery|cli'
forbidden theory 'bem|exact|compare|gallery|import|cli'
forbidden compare 'sph|bem|exact|theory|gallery|import|cli'
forbidden gallery 'sph|bem|exact|import|cli'

exported() { # library, allowed prefixes
  local strangers
  strangers=$(nm -g --defined-only "$build/libplunge_$1.a" | awk 'NF == 3 {print $3}' |
    grep -vE "^(_|\.)" | grep -vE "^($2)_" | sort -u)
  [ -z "$strangers" ] || complain "libplunge_$1 exports names without its prefix: $strangers"
}
exported common 'array|case|record|text|TEXT|file|result|health|guard|carry|geo|gauge|tank|faces?|images|rigid|cloud|flow|release|root|wave|progress|status|params?|problems|vtkhdf|xdmf|hdf|CASE'
exported sph 'sph'
exported bem 'bem'
exported exact 'exact'
exported theory 'theory'
exported import import
exported compare cmp
exported gallery gallery

while read -r lines file; do
  complain "$file has $lines lines"
done < <(find common sph bem exact theory compare gallery import cli tests bench -name "*.[ch]" -exec wc -l {} + | awk '$1 > 600 && $2 != "total"')
exit $failed
