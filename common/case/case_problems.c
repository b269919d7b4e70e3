/* The list of what is wrong with a case file. */
#include "common/base/array.h"
#include "common/case/case_doc.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LISTED = 100 }; /* nobody reads more, and a hostile file has millions */

static enum status make_room(struct problems *p) {
  size_t room = array_room(p->room, p->n + 1);
  if (room == p->room) return OK;
  TRY(array_resize(&p->text, room, "problems"));
  TRY(array_resize(&p->line, room, "problems"));
  p->room = room;
  return OK;
}

void problems_add(struct problems *p, int line, const char *format, ...) {
  char *text = NULL;
  va_list args;
  if (p->n >= MOST_LISTED) {
    p->unlisted++;
    return;
  }
  va_start(args, format);
  if (vasprintf(&text, format, args) < 0) text = NULL;
  va_end(args);
  if (!text || make_room(p) != OK) {
    free(text);
    p->out_of_memory = true;
    return;
  }
  p->text[p->n] = text;
  p->line[p->n++] = line;
}

void problems_destroy(struct problems *p) {
  for (size_t i = 0; i < p->n; i++) free(p->text[i]);
  free(p->text);
  free(p->line);
  *p = (struct problems){0};
}

/* The file as a whole, its lines in order, then the command line's words in order. */
static bool comes_before(int a, int b) {
  if ((a < 0) != (b < 0)) return b < 0;
  return a < 0 ? a > b : a < b;
}

static void put_in_order(struct problems *p) {
  for (size_t i = 1; i < p->n; i++) { /* stable; at most a hundred */
    char *text = p->text[i];
    int line = p->line[i];
    size_t j = i;
    for (; j > 0 && comes_before(line, p->line[j - 1]); j--) {
      p->text[j] = p->text[j - 1];
      p->line[j] = p->line[j - 1];
    }
    p->text[j] = text;
    p->line[j] = line;
  }
}

static bool say_where(struct problems *p, size_t i, const char *file, size_t n_set,
                      const char *const *set) {
  char *text = NULL, shown[96];
  int line = p->line[i], n;
  size_t k = line < 0 ? (size_t)(-(long)line - 1) : 0;
  if (line < 0 && k < n_set) {
    case_quote(set[k], strlen(set[k]), shown, sizeof shown);
    n = asprintf(&text, "--set %s: %s", shown, p->text[i]);
  } else if (line > 0) {
    n = asprintf(&text, "%s:%d: %s", file, line, p->text[i]);
  } else {
    n = asprintf(&text, "%s: %s", file, p->text[i]);
  }
  if (n < 0) return false;
  free(p->text[i]);
  p->text[i] = text;
  return true;
}

void problems_finish(struct problems *p, const char *file, size_t n_set, const char *const *set) {
  put_in_order(p);
  if (p->unlisted && make_room(p) == OK) {
    char *text = NULL;
    if (asprintf(&text, "%zu more problems are not listed", p->unlisted) >= 0) {
      p->text[p->n] = text;
      p->line[p->n++] = 0;
    }
  }
  for (size_t i = 0; i < p->n; i++)
    if (!say_where(p, i, file, n_set, set)) p->out_of_memory = true;
}

void case_quote(const char *s, size_t n, char *out, size_t size) {
  size_t shown = n, room = size - 4, at = 0; /* "..." and NUL */
  for (size_t i = 0; i < shown; i++) {
    unsigned char c = (unsigned char)s[i];
    char piece[8];
    size_t bytes = 1;
    if (c < 32 || c == 127) {
      snprintf(piece, sizeof piece, "\\x%02x", c);
    } else {
      while (i + bytes < n && bytes < 4 && ((unsigned char)s[i + bytes] & 0xc0) == 0x80) bytes++;
      memcpy(piece, s + i, bytes); /* never cuts a UTF-8 character in two */
      piece[bytes] = 0;
    }
    if (at + strlen(piece) > room) {
      strcpy(out + at, "...");
      return;
    }
    strcpy(out + at, piece);
    at += strlen(piece);
    i += bytes - 1;
  }
  out[at] = 0;
}
