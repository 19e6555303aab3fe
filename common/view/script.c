// A script of keys and mouse events (see script.h).
//
// Read next: controls.c, which takes them.
#include "script.h"

#include "number.h"
#include "text_file.h"

#include <string.h>

enum { MAX_WORDS = 6, LARGEST_NUMBER = 100000 };

int script_open(Script *script, const char *path)
{
    *script = (Script){0};
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    line_reader_begin(&script->reader, file, path);
    return 0;
}

void script_close(Script *script)
{
    if (script->reader.file != NULL) {
        fclose(script->reader.file);
    }
    *script = (Script){0};
}

// ---- Events -----------------------------------------------------------------------------------

// Events leave from the end of the list: the last one first.
static SDL_Event *event_add(Script *script, Uint32 type)
{
    SDL_Event *event = &script->events[script->n_events++];
    memset(event, 0, sizeof *event);
    event->type = type;
    event->common.timestamp = SDL_GetTicks();
    return event;
}

static void key_add(Script *script, Uint32 type, SDL_Keycode key)
{
    event_add(script, type)->key.keysym.sym = key;
}

static void button_add(Script *script, Uint32 type, int button, int64_t x, int64_t y)
{
    SDL_MouseButtonEvent *event = &event_add(script, type)->button;
    event->button = (Uint8)button;
    event->x = (Sint32)x;
    event->y = (Sint32)y;
}

static void drag_add(Script *script, int button, const int64_t *n)
{
    button_add(script, SDL_MOUSEBUTTONUP, button, n[2], n[3]);
    SDL_MouseMotionEvent *motion = &event_add(script, SDL_MOUSEMOTION)->motion;
    motion->x = (Sint32)n[2];
    motion->y = (Sint32)n[3];
    button_add(script, SDL_MOUSEBUTTONDOWN, button, n[0], n[1]);
}

static void wheel_add(Script *script, const int64_t *n)
{
    SDL_MouseWheelEvent *wheel = &event_add(script, SDL_MOUSEWHEEL)->wheel;
    wheel->y = (Sint32)n[0];
    wheel->mouseX = (Sint32)n[1];
    wheel->mouseY = (Sint32)n[2];
}

// ---- Lines ------------------------------------------------------------------------------------

// The commands, by what follows their name.
enum Command { KEY, DOWN, UP, CLICK, DRAG, WHEEL, FRAMES, SAVE, N_COMMANDS };
static const struct CommandRow {
    const char *name;
    int n_numbers;  // -1: one word
    const char *expected;
} COMMANDS[N_COMMANDS] = {
    [KEY] = {"key", -1, "key NAME"},
    [DOWN] = {"down", -1, "down NAME"},
    [UP] = {"up", -1, "up NAME"},
    [CLICK] = {"click", 2, "click X Y"},
    [DRAG] = {"drag", 4, "drag X Y X2 Y2 [right]"},
    [WHEEL] = {"wheel", 3, "wheel N X Y"},
    [FRAMES] = {"frames", 1, "frames N"},
    [SAVE] = {"save", -1, "save FILE"},
};

// What stands behind a command's name.
typedef struct Arguments {
    const char *word;  // NULL where it takes numbers
    int64_t n[MAX_WORDS];
    int button;  // of a drag
} Arguments;

// Take in what a command asks for.
static void command_take(Script *script, enum Command command, const Arguments *arguments)
{
    const int64_t *n = arguments->n;
    const SDL_Keycode key = arguments->word != NULL ? SDL_GetKeyFromName(arguments->word) : 0;
    switch (command) {
    case KEY:
        key_add(script, SDL_KEYUP, key);
        key_add(script, SDL_KEYDOWN, key);
        break;
    case DOWN:
        key_add(script, SDL_KEYDOWN, key);
        break;
    case UP:
        key_add(script, SDL_KEYUP, key);
        break;
    case CLICK:
        button_add(script, SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT, n[0], n[1]);
        button_add(script, SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, n[0], n[1]);
        break;
    case DRAG:
        drag_add(script, arguments->button, n);
        break;
    case WHEEL:
        wheel_add(script, n);
        break;
    case FRAMES:
        script->n_frames = (int)n[0];
        break;
    case SAVE:
        strcpy(script->save, arguments->word);
        break;
    case N_COMMANDS:
        break;
    }
}

static enum Command command_find(const char *name)
{
    enum Command command = 0;
    while (command < N_COMMANDS && strcmp(COMMANDS[command].name, name) != 0) {
        command++;
    }
    return command;
}

// Read what stands behind a command's name. Returns 0, or -1 where it is not what the command
// takes.
static int arguments_read(enum Command command, char **words, int n_words, Arguments *arguments)
{
    *arguments = (Arguments){.button = SDL_BUTTON_LEFT};
    if (COMMANDS[command].n_numbers < 0) {
        arguments->word = n_words == 1 ? words[0] : NULL;
        const int is_right =
            n_words == 1 && (command == SAVE || SDL_GetKeyFromName(words[0]) != SDLK_UNKNOWN);
        return is_right ? 0 : -1;
    }
    if (command == DRAG && n_words == 5 && strcmp(words[4], "right") == 0) {
        arguments->button = SDL_BUTTON_RIGHT;
        n_words--;
    }
    if (n_words != COMMANDS[command].n_numbers) {
        return -1;
    }
    int result = 0;
    for (int i = 0; result == 0 && i < n_words; i++) {
        result = number_read_integer(words[i], -LARGEST_NUMBER, LARGEST_NUMBER, &arguments->n[i]);
    }
    return result;
}

// Take in the line at hand. Returns the command, or N_COMMANDS after one message; KEY, with no
// event, for an empty line.
static enum Command line_take(Script *script)
{
    LineReader *reader = &script->reader;
    char line[LINE_MAX_LENGTH + 1], quoted[LINE_QUOTE_SIZE];
    strcpy(line, reader->text);
    char *words[MAX_WORDS];
    const int n_words = line_split(line, words, MAX_WORDS);
    if (n_words == 0 || words[0][0] == '#') {
        return KEY;
    }
    const enum Command command = command_find(words[0]);
    if (command == N_COMMANDS) {
        line_fault(reader, "", line_quote(words[0], quoted),
                   "key, down, up, click, drag, wheel, frames or save");
        return N_COMMANDS;
    }
    Arguments arguments;
    if (arguments_read(command, words + 1, n_words - 1, &arguments) != 0) {
        line_fault(reader, "", line_quote(reader->text, quoted), COMMANDS[command].expected);
        return N_COMMANDS;
    }
    command_take(script, command, &arguments);
    return command;
}

ScriptStep script_next(Script *script, SDL_Event *event)
{
    for (;;) {
        if (script->n_events > 0) {
            *event = script->events[--script->n_events];
            return SCRIPT_EVENT;
        }
        if (script->n_frames > 0) {
            script->n_frames--;
            return SCRIPT_FRAME;
        }
        if (!line_read(&script->reader)) {
            return script->reader.failed ? SCRIPT_BAD : SCRIPT_END;
        }
        switch (line_take(script)) {
        case SAVE:
            return SCRIPT_SAVE;
        case N_COMMANDS:
            return SCRIPT_BAD;
        default:
            break;
        }
    }
}
