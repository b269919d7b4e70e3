/* A YAML document read with parameter tables: where every section of a case file passes through.
 * Internal to the case reader. */
#pragma once
#include <yaml.h>

#include "common/base/params.h"
#include "common/case/case.h"

struct case_doc {
  yaml_document_t yaml;
  bool loaded;
  struct problems *problems;
  struct param_scales scales;
  size_t faults; /* found so far, also those that are not listed one by one */
  bool H_missed; /* a unit needed H while it was unknown: reported once */
};

enum { CASE_PATH = 192 }; /* room for "runs.NAME.key" and the like */

/* Parses `text` (without NUL bytes). False with problems added; case_doc_destroy in any case. */
bool case_doc_load(struct case_doc *d, const char *text, size_t n, struct problems *problems);
/* The same of a text that is no case: of an empty one it says that `wanted` is allowed. */
bool case_doc_load_other(struct case_doc *d, const char *text, size_t n, const char *wanted,
                         struct problems *problems);
void case_doc_destroy(struct case_doc *d);

/* Applies "path=value" number k (from 0); adds a problem when the path leads nowhere. */
void case_doc_set(struct case_doc *d, size_t k, const char *assignment);

/* The document as YAML text, owned by the caller; ends the document. ERR_MEMORY. */
enum status case_doc_emit(struct case_doc *d, char **text);

/* ---- nodes; a node is a positive int, 0 stands for an absent one ---- */

int case_doc_root(struct case_doc *d);
int case_doc_line(struct case_doc *d, int node); /* as problems_add takes it */
bool case_doc_is_list(struct case_doc *d, int node);
bool case_doc_is_mapping(struct case_doc *d, int node);
size_t case_doc_size(struct case_doc *d, int node); /* items of a list; 0 of anything else */
int case_doc_item(struct case_doc *d, int node, size_t i);
const char *case_doc_text(struct case_doc *d, int node);            /* of a scalar, else NULL */
int case_doc_member(struct case_doc *d, int node, const char *key); /* value in a mapping, or 0 */

/* The line of node.key when given, of the node when not. */
int case_doc_member_line(struct case_doc *d, int node, const char *key);

/* "list.NAME" when the item has a name that fits, else "list[i]". */
void case_doc_item_path(struct case_doc *d, const char *list, int item, size_t i,
                        char out[CASE_PATH]);

/* Whether `name` can name a file or a series: [A-Za-z0-9._-], no leading '.', at most 64 bytes. */
bool case_name_fits(const char *name);

/* ---- reading with tables ---- */

struct case_block { /* one struct and the table that describes it */
  const struct param *params;
  size_t n;
  void *into;
  const struct param_preset *preset; /* its values are the defaults; or NULL */
};

/* Reads the mapping `node` (0: absent, everything has its default) called `path` ("" for the top
 * level) into the blocks. True when there was no problem. */
bool case_doc_read(struct case_doc *d, int node, const char *path, int line_if_absent,
                   size_t n_blocks, const struct case_block *blocks);

/* Reads one value as row `p` says. */
bool case_doc_value(struct case_doc *d, int node, const char *path, const struct param *p,
                    void *into);

/* True when `node` is a list of n_min to n_max items, else adds a problem. */
bool case_doc_expect_list(struct case_doc *d, int node, const char *path, size_t n_min,
                          size_t n_max, const char *what);

/* Adds "path: found ...; allowed: ...; what to do" (the last may be ""). */
void case_doc_problem(struct case_doc *d, int line, const char *path, const char *found,
                      const char *allowed, const char *todo);

/* What a word may be and which of it was perhaps meant, for messages: "one of a, b, c" behind the
 * lead "one of ", and "did you mean 'b'?" or "". `text` is what stands there, or NULL. */
struct case_offer {
  char allowed[1024], todo[96];
};
struct case_offer case_offer(const char *lead, size_t n, const char *const *names,
                             const char *text);

/* What stands at `node`, for messages: 'text', "a list", "a mapping", "nothing". */
void case_doc_found(struct case_doc *d, int node, char out[64]);

/* `s` without control characters and shortened to fit, for messages. */
void case_quote(const char *s, size_t n, char *out, size_t size);
