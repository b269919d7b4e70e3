#!/usr/bin/env bash
# plunge movie: a frame for every output, films of the size and speed asked for, frames without ffmpeg, nothing left by a stop.
source "$2/tests/cli/begin"
command -v gnuplot >/dev/null || { echo "gnuplot is not installed"; exit 77; }

refuse() { # words of the one complaint, then arguments
  local words=$1
  shift
  code 2 "$program" movie "$@"
  grep -qF -- "$words" talk || fail "$*: expected '$words', found '$(cat talk)'"
  [ ! -e film.mp4 ] && [ ! -e out ] || fail "$*: something is left"
}
hidden() { find . -name '.drawing-*' | grep -q . && fail "$1 leaves a folder"; }

small_dam 3 1 0.2 <<'E2'
runs:
  - {name: bem, solver: bem, resolution: 15}
  - {name: sph, solver: sph, resolution: 15}
compare:
  reference: bem
E2
for run in bem sph; do
  "$program" run dam.yaml --out . --only $run --threads 1 --no-report -q >log 2>&1 || fail "no run: $(cat log)"
done

# ---- frames in a folder: one for each output, all of one size, which change; those of before go ----
mkdir frames
touch frames/frame-00099.png frames/mine.txt
code 0 "$program" movie bem.h5 sph.h5 --out frames
grep -qx "movie: frames" log || fail "no word: $(cat log)"
[ "$(cd frames && echo *)" = "frame-00001.png frame-00002.png frame-00003.png frame-00004.png frame-00005.png frame-00006.png mine.txt" ] ||
  fail "frames: $(ls frames)"
[ "$(md5sum frames/*.png | cut -c1-32 | sort -u | wc -l)" = 6 ] || fail "frames are alike"
size() { od -An -tu1 -j16 -N8 "$1" | awk '{print $3 * 256 + $4 "x" $7 * 256 + $8}'; }
for k in 1 6; do [ "$(size frames/frame-0000$k.png)" = "$(size frames/frame-00003.png)" ] || fail "frames of several sizes"; done
[ "$(size frames/frame-00001.png | cut -dx -f1)" = 1280 ] || fail "frames are $(size frames/frame-00001.png)"
hidden "a folder of frames"
code 0 "$program" movie sph.h5 --what density --out later --from "0.3 sqrt(H/g)" --to 0.2 --size 640x480
[ "$(ls later | wc -l)" = 3 ] || fail "of 0.4, 0.6, 0.8: $(ls later)"
[ "$(size later/frame-00001.png | cut -dx -f1)" -le 640 ] || fail "larger than asked for: $(size later/frame-00001.png)"
for what in pressure speed; do
  code 0 "$program" movie sph.h5 bem.h5 --what $what --out $what --to 0.01
  cmp -s $what/frame-00001.png later/frame-00001.png && fail "$what is density"
done

# ---- one result without points: its surface ----
code 0 "$program" movie bem.h5 --out surface
[ "$(ls surface | wc -l)" = 6 ] && [ "$(md5sum surface/*.png | cut -c1-32 | sort -u | wc -l)" = 6 ] || fail "one surface: $(ls surface)"

# ---- without ffmpeg: the frames, with a word ----
mkdir bin
ln -s "$(command -v gnuplot)" bin/gnuplot
PATH=$folder/bin code 0 "$program" movie bem.h5 sph.h5 --out film.mp4 --to 0.06
grep -qx "plunge: ffmpeg is not installed (apt install ffmpeg): the frames are in film-frames" talk || fail "no word: $(cat talk)"
[ ! -e film.mp4 ] && [ "$(ls film-frames)" = "frame-00001.png
frame-00002.png" ] || fail "without ffmpeg: $(ls . film-frames)"
rm bin/gnuplot
PATH=$folder/bin code 3 "$program" movie sph.h5 --out film.mp4
grep -q "gnuplot is not installed" talk || fail "without gnuplot: $(cat talk)"
ln -s "$(command -v gnuplot)" bin/gnuplot
printf '#!/bin/sh\necho "Unknown encoder" >&2\nexit 1\n' >bin/ffmpeg
chmod +x bin/ffmpeg
PATH=$folder/bin:$PATH code 3 "$program" movie sph.h5 --out film.mp4 --to 0.01
grep -qx "plunge: ffmpeg could not write the film: Unknown encoder" talk || fail "a failing ffmpeg: $(cat talk)"
[ ! -e film.mp4 ] || fail "a failing ffmpeg leaves a film"
hidden "a failing ffmpeg"

# ---- films ----
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
  probe() { ffprobe -v error -count_frames -select_streams v -show_entries "stream=$1" -of csv=p=0 "$2"; }
  code 0 "$program" movie bem.h5 sph.h5 --out one.mp4 --fps 10
  [ "$(probe codec_name,width,pix_fmt,r_frame_rate,nb_read_frames one.mp4)" = "h264,1280,yuv420p,10/1,6" ] ||
    fail "one.mp4: $(probe codec_name,width,pix_fmt,r_frame_rate,nb_read_frames one.mp4)"
  code 0 "$program" movie sph.h5 --what speed --out one.gif --size 321x201 --fps 20 --to 0.15
  [ "$(probe codec_name,width,height,nb_read_frames one.gif)" = "gif,321,201,4" ] || fail "one.gif: $(probe codec_name,width,height,nb_read_frames one.gif)"
  code 0 "$program" movie bem.h5 sph.h5 --out one.webm --size 320x180 --to 0.06
  [ "$(probe codec_name,width,height,nb_read_frames one.webm)" = "vp9,320,180,2" ] || fail "one.webm: $(probe codec_name,width,height,nb_read_frames one.webm)"
  hidden "a film"
else
  echo "ffmpeg is not installed: no film was tried"
fi

# ---- a stop leaves nothing ----
mkdir stop
for signal in INT TERM; do
  "$program" movie bem.h5 sph.h5 --out stop/film.mp4 >log 2>talk &
  pid=$!
  for _ in $(seq 400); do
    [ -n "$(find stop -name 'frame-*.gp' 2>/dev/null)" ] && break
    sleep 0.02
  done
  kill -$signal $pid
  got=0
  wait $pid || got=$?
  [ $got = 3 ] || fail "$signal: exit code $got: $(cat talk)"
  [ -z "$(ls -A stop)" ] || fail "$signal leaves $(ls -A stop)"
done

# ---- wrong words ----
refuse "name at least one result"
refuse "--what: found vorticity, allowed: overlay, pressure, speed, density" sph.h5 --what vorticity --out film.mp4
refuse "--fps 0: give frames a second, from 0.1 to 240" sph.h5 --fps 0
refuse "--fps ten: give frames a second, from 0.1 to 240" sph.h5 --fps ten
refuse "--fps 60: a GIF has at most 50 frames a second" sph.h5 --fps 60 --out film.gif
for size in 640 640x 63x64 640x480x3 9000x640 -640x480; do
  refuse "--size $size: give pixels from 64x64 to 7680x7680, as in 1280x720" sph.h5 --size=$size
done
refuse "--size 641x480: such a film has even numbers of pixels" sph.h5 --size 641x480 --out film.mp4
refuse "--out: found a name that ends in .avi, allowed: .mp4, .webm, .gif, or a folder for frames, without a suffix" sph.h5 --out film.avi
refuse "--out: the name is empty" sph.h5 --out=
long=$(printf 'long/%.0s' $(seq 900))
refuse "--out: found a path of 4508 bytes, allowed: at most 4032; choose a shorter one" sph.h5 --out "${long}film.mp4"
[ ! -e long ] || fail "a path that is too long leaves folders"
mkdir taken.mp4
refuse "taken.mp4 is a folder; choose another --out" sph.h5 --out taken.mp4
touch taken
refuse "taken is not a folder; choose another --out" sph.h5 --out taken
refuse "--from: found soon, allowed: a time in s, or as in '4 sqrt(H/g)'" sph.h5 --from soon --out film.mp4
refuse "--to: found 3 h, allowed: a time in s" sph.h5 --to "3 h" --out film.mp4
refuse "--from: found -1, allowed: a time of at least 0" sph.h5 --from=-1 --out film.mp4
refuse "--from 0.2 is after --to 0.1" sph.h5 --from 0.2 --to 0.1 --out film.mp4
refuse "sph.h5 has no output from 7 s to inf s; its outputs are from 0 s to 0.24731 s" sph.h5 --from 7 --out film.mp4
refuse "none of the results has points in its water with velocity; --what overlay draws surfaces alone" bem.h5 --what speed --out film.mp4
refuse "missing.h5" missing.h5 --out film.mp4
refuse "dam.yaml is not a result file" dam.yaml --out film.mp4

"$program" run dam.yaml --out other --only sph --set time.end="0.4 sqrt(H/g)" --threads 1 --no-report -q >log 2>&1 || fail "no run: $(cat log)"
refuse "no other result has an output at any of the 2 times of bem.h5" bem.h5 other/sph.h5 --from 0.18 --out film.mp4

# ---- a name that would be a command ----
/usr/bin/python3 -c 'import h5py' 2>/dev/null || exit $failed
cp sph.h5 evil.h5
/usr/bin/python3 - <<'E2' || fail "no made-up name"
import h5py
with h5py.File("evil.h5", "r+") as f: f.attrs["run"] = "'; system 'touch hit' #\n`touch hit`$(touch hit)"
E2
code 0 "$program" movie bem.h5 evil.h5 --out evil --to 0.01
[ -z "$(find . -name hit)" ] || fail "a name was a command"
exit $failed
