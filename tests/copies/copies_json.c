// copies.json: the pairs for programs (see alike.h).
#include "alike.h"

#include "hard.h"
#include "json_text.h"

#include <math.h>
#include <stdlib.h>

static double rounded(double number)
{
    return round(100 * number) / 100;
}

static json_t *entrant_json(const Entrant *entrant)
{
    return json_pack("{s:o, s:s}", "name", json_line(entrant->label), "id", entrant->slug);
}

static json_t *author_json(const Author *author)
{
    return entrant_json(author->entrant);
}

static const char *kind_name(FormKind kind)
{
    static const char *const names[] = {[FORM_STATEMENT] = "statement",
                                        [FORM_COMMENT] = "comment",
                                        [FORM_NAME] = "name",
                                        [FORM_BLANKS] = "blanks"};
    return names[kind];
}

// So many forms of a pair are listed: what nobody reads must not fill the memory.
enum { MOST_FORMS = 1000 };

static json_t *forms_json(const Alike *alike, const Pair *pair)
{
    json_t *list = json_array();
    for (int id = 0; id < alike->weights.n && json_array_size(list) < MOST_FORMS; id++) {
        const Weight *weight = &alike->weights.all[id];
        if (weight->nats > 0 && weight->n_authors > 1 && is_shared(alike, pair, id)) {
            json_array_append_new(
                list, json_pack("{s:s, s:o, s:i, s:f}", "kind", kind_name(weight->form->kind),
                                "form", json_line(weight->form->text), "authors", weight->n_authors,
                                "weight", rounded(weight->nats)));
        }
    }
    return list;
}

static json_t *pair_json(const Alike *alike, const Pair *pair)
{
    const Author *authors = alike->class.authors;
    return json_pack("{s:[o, o], s:f, s:f, s:f, s:i, s:i, s:o}", "authors",
                     author_json(&authors[pair->first]), author_json(&authors[pair->second]),
                     "score", rounded(pair->score), "weight", rounded(pair->nats), "share",
                     rounded(pair->share), "shared", pair->n_shared, "only_these_two",
                     pair->n_only_two, "forms", forms_json(alike, pair));
}

// Whose answers are hard to compare, and why.
static json_t *hard_json(const Alike *alike)
{
    json_t *list = json_array();
    for (int i = 0; i < alike->class.n_authors; i++) {
        const Author *author = &alike->class.authors[i];
        char *reason = hard_reason(alike, author);
        if (reason != NULL) {
            json_array_append_new(
                list, json_pack("{s:o, s:s}", "author", author_json(author), "found", reason));
        }
        free(reason);
    }
    return list;
}

static json_t *unread_json(const HandedIn *class)
{
    json_t *list = json_array();
    for (int i = 0; i < class->n_unread; i++) {
        json_array_append_new(list, entrant_json(class->unread[i]));
    }
    return list;
}

int copies_json(const Alike *alike, const char *path)
{
    const Pairs *pairs = &alike->pairs;
    json_t *list = json_array();
    for (int i = 0; i < pairs->n_listed; i++) {
        json_array_append_new(list, pair_json(alike, &pairs->all[i]));
    }
    json_t *json = json_pack(
        "{s:s, s:i, s:i, s:o, s:i, s:f, s:i, s:b, s:o, s:o}", "lab", alike->class.manifest.lab,
        "authors", alike->class.n_authors, "without", alike->class.n_without, "unread",
        unread_json(&alike->class), "pairs_compared", pairs->n_compared, "level",
        rounded(pairs->level), "tellable", pairs->n_tellable, "too_short",
        pairs_are_too_few(&alike->class, pairs), "hard", hard_json(alike), "pairs", list);
    return json_save(path, json, JSON_INDENT(1));
}
