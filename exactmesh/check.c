/* Check an exactmesh-certificate/1: a second checker, which shares no code with check.py. C99, no dependency.
 *
 *     cc -std=c99 -O2 -o check check.c
 *     ./check PSLG MESH CERTIFICATE [--max-bytes N] [--max-digits N] [--max-items N]
 *
 * Prints one line, the same as check.py does: `VALID ...`, which states what is proved, or `INVALID clause: place`.
 * Exit status: 0 valid, 1 invalid, 2 usage, a file that cannot be read, or no memory. docs/certificate.md describes the
 * format and proves, clause by clause, that what is accepted is true.
 *
 * Integers of any size, nothing is rounded; no recursion. Memory is linear in the files. Nothing is freed before the
 * end: the program runs once.
 */

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __GNUC__
#define NO_RETURN __attribute__((noreturn))
#define LIKE_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define NO_RETURN
#define LIKE_PRINTF(text, first)
#endif

enum { VALID, INVALID, REFUSED };

static int64_t max_bytes = INT64_C(1) << 28, max_digits = 4000, max_items = 20000000;

/* --- ends --- */

static void refuse(const char *clause, const char *place, ...) NO_RETURN LIKE_PRINTF(2, 3);
static void refuse(const char *clause, const char *place, ...) {
    va_list values;
    printf("INVALID %s: ", clause);
    va_start(values, place);
    vprintf(place, values);
    va_end(values);
    putchar('\n');
    exit(fflush(stdout) ? REFUSED : INVALID);
}

static void give_up(const char *name, const char *why) NO_RETURN;
static void give_up(const char *name, const char *why) {
    fprintf(stderr, "check: %s: %s\n", name, why);
    exit(REFUSED);
}

/* Return room for `count` > 0 things of `size` bytes, with what was in `old`. */
static void *room_for(void *old, size_t count, size_t size) {
    void *found = count > SIZE_MAX / 2 / size ? NULL : realloc(old, count * size);
    if (!found) give_up("memory", "there is not enough");
    return found;
}

/* --- integers of any size: a sign and a magnitude of 32-bit limbs, the least first, the last one not 0 --- */

typedef struct {
    uint32_t *limb;
    size_t count, room;
    int sign; /* -1, 0, 1 */
} Big;

static void reserve(Big *a, size_t count) {
    if (a->room >= count && a->limb) return;
    a->room = count + 2;
    a->limb = room_for(a->limb, a->room, sizeof *a->limb);
}

static void trim(Big *a, int sign) {
    while (a->count && !a->limb[a->count - 1]) a->count--;
    a->sign = a->count ? sign : 0;
}

static void set_small(Big *a, uint32_t value) {
    reserve(a, 1);
    a->limb[0] = value;
    a->count = 1;
    trim(a, 1);
}

static void copy(Big *to, const Big *from) {
    reserve(to, from->count);
    if (from->count) memcpy(to->limb, from->limb, from->count * sizeof *to->limb);
    to->count = from->count;
    to->sign = from->sign;
}

/* a = a * factor + more, for a >= 0 */
static void scale(Big *a, uint32_t factor, uint32_t more) {
    uint64_t carry = more;
    size_t i;
    reserve(a, a->count + 1);
    for (i = 0; i < a->count; i++) {
        carry += (uint64_t)a->limb[i] * factor;
        a->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    a->limb[a->count++] = (uint32_t)carry;
    trim(a, 1);
}

static int compare_magnitudes(const Big *a, const Big *b) {
    size_t i;
    if (a->count != b->count) return a->count < b->count ? -1 : 1;
    for (i = a->count; i-- > 0;)
        if (a->limb[i] != b->limb[i]) return a->limb[i] < b->limb[i] ? -1 : 1;
    return 0;
}

static int compare(const Big *a, const Big *b) {
    if (a->sign != b->sign) return a->sign < b->sign ? -1 : 1;
    return a->sign * compare_magnitudes(a, b);
}

/* r = a * b; r is neither a nor b */
static void multiply(Big *r, const Big *a, const Big *b) {
    size_t i, j;
    reserve(r, a->count + b->count);
    r->count = a->count + b->count;
    if (r->count) memset(r->limb, 0, r->count * sizeof *r->limb);
    for (i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (j = 0; j < b->count; j++) {
            carry += (uint64_t)a->limb[i] * b->limb[j] + r->limb[i + j];
            r->limb[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        r->limb[i + b->count] = (uint32_t)carry;
    }
    trim(r, a->sign * b->sign);
}

/* r = a + sign * b; r may be a or b */
static void add(Big *r, const Big *a, const Big *b, int sign) {
    const int other = b->sign * sign;
    uint64_t carry = 0;
    size_t i;
    if (a->sign == other || !a->sign || !other) {
        const size_t count = a->count > b->count ? a->count : b->count;
        const int result = a->sign ? a->sign : other;
        reserve(r, count + 1); /* moves the limbs of a or b when r is one of them, and they follow */
        for (i = 0; i < count; i++) {
            carry += (uint64_t)(i < a->count ? a->limb[i] : 0) + (i < b->count ? b->limb[i] : 0);
            r->limb[i] = (uint32_t)carry;
            carry >>= 32;
        }
        r->limb[count] = (uint32_t)carry;
        r->count = count + 1;
        trim(r, result);
    } else {
        const int order = compare_magnitudes(a, b);
        const Big *large = order >= 0 ? a : b, *small = order >= 0 ? b : a;
        const size_t count = large->count;
        const int result = order >= 0 ? a->sign : other;
        reserve(r, count);
        for (i = 0; i < count; i++) {
            const uint64_t less = (i < small->count ? small->limb[i] : 0) + carry, from = large->limb[i];
            carry = from < less;
            r->limb[i] = (uint32_t)(from + (carry << 32) - less);
        }
        r->count = count;
        trim(r, result);
    }
}

/* r = a * b + sign * c * d; r is none of them */
static void combine(Big *r, const Big *a, const Big *b, int sign, const Big *c, const Big *d) {
    static Big second;
    multiply(r, a, b);
    multiply(&second, c, d);
    add(r, r, &second, sign);
}

/* a = a * 10^count + the integer with these digits, for a >= 0 */
static void append_digits(Big *a, const char *digits, size_t count) {
    size_t i = 0;
    while (i < count) {
        uint32_t part = 0, power = 1;
        for (; power < 1000000000 && i < count; i++, power *= 10) part = part * 10 + (uint32_t)(digits[i] - '0');
        scale(a, power, part);
    }
}

/* a = a * 10^count, for a >= 0 */
static void append_zeros(Big *a, size_t count) {
    for (; count >= 9; count -= 9) scale(a, 1000000000, 0);
    for (; count > 0; count--) scale(a, 10, 0);
}

typedef struct {
    Big over, under; /* under > 0 */
} Ratio;

static int is_less(const Ratio *a, const Ratio *b) {
    static Big left, right;
    multiply(&left, &a->over, &b->under);
    multiply(&right, &b->over, &a->under);
    return compare(&left, &right) < 0;
}

/* --- SHA-256 (FIPS 180-4) --- */

typedef struct {
    uint32_t state[8];
    uint64_t length;
    unsigned char block[64];
} Sha;

static const uint32_t SHA_START[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
static const uint32_t SHA_ROUND[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

static uint32_t rotate(uint32_t x, int by) { return (x >> by) | (x << (32 - by)); }

static void sha_block(Sha *sha) {
    uint32_t w[64], s[8];
    int i;
    for (i = 0; i < 16; i++)
        w[i] = (uint32_t)sha->block[4 * i] << 24 | (uint32_t)sha->block[4 * i + 1] << 16 |
               (uint32_t)sha->block[4 * i + 2] << 8 | sha->block[4 * i + 3];
    for (; i < 64; i++)
        w[i] = w[i - 16] + w[i - 7] + (rotate(w[i - 15], 7) ^ rotate(w[i - 15], 18) ^ (w[i - 15] >> 3)) +
               (rotate(w[i - 2], 17) ^ rotate(w[i - 2], 19) ^ (w[i - 2] >> 10));
    memcpy(s, sha->state, sizeof s);
    for (i = 0; i < 64; i++) {
        const uint32_t first = s[7] + (rotate(s[4], 6) ^ rotate(s[4], 11) ^ rotate(s[4], 25)) +
                               ((s[4] & s[5]) ^ (~s[4] & s[6])) + SHA_ROUND[i] + w[i];
        const uint32_t second = (rotate(s[0], 2) ^ rotate(s[0], 13) ^ rotate(s[0], 22)) +
                                ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += first;
        s[0] = first + second;
    }
    for (i = 0; i < 8; i++) sha->state[i] += s[i];
}

static void sha_add(Sha *sha, const unsigned char *data, size_t count) {
    size_t i;
    for (i = 0; i < count; i++) {
        sha->block[sha->length++ % 64] = data[i];
        if (sha->length % 64 == 0) sha_block(sha);
    }
}

static void sha_text(Sha *sha, char text[65]) {
    static const unsigned char padding[72] = {0x80};
    const uint64_t bits = sha->length * 8;
    unsigned char end[8];
    int i;
    for (i = 0; i < 8; i++) end[i] = (unsigned char)(bits >> (56 - 8 * i));
    sha_add(sha, padding, 1 + (119 - sha->length % 64) % 64);
    sha_add(sha, end, 8);
    for (i = 0; i < 8; i++) sprintf(text + 8 * i, "%08lx", (unsigned long)sha->state[i]);
}

/* --- reading: a strict part of JSON, token by token --- */

typedef struct {
    const char *name, *path;
    FILE *file;
    unsigned char block[65536];
    size_t have, at;
    int64_t read, start, items; /* bytes in all blocks; place of the last token; items of lists */
    int is_over, is_ended;
    char *token; /* the last one, ended by a NUL; strings have their first quote and no last one */
    size_t length, room;
    Sha sha;
} Tokens;

enum { END = -1, OVER = -2 };

static void wrong(const Tokens *t, const char *expected) NO_RETURN;
static void wrong(const Tokens *t, const char *expected) {
    refuse("format", "%s: byte %lld: %s expected", t->name, (long long)t->start, expected);
}

static void too_long(const Tokens *t) NO_RETURN;
static void too_long(const Tokens *t) { refuse("size", "%s: byte %lld: too long", t->name, (long long)t->start); }

static void too_many(const Tokens *t, int64_t limit, const char *what) NO_RETURN;
static void too_many(const Tokens *t, int64_t limit, const char *what) {
    refuse("size", "%s: more than %lld %s", t->name, (long long)limit, what);
}

static void open_file(Tokens *t, const char *name, const char *path) {
    memset(t, 0, sizeof *t);
    memcpy(t->sha.state, SHA_START, sizeof SHA_START);
    t->name = name;
    t->path = path;
    t->file = fopen(path, "rb");
    if (!t->file) give_up(path, "cannot be read");
}

/* Return the next byte without passing it, END, or OVER where more bytes follow than may be read. */
static int look(Tokens *t) {
    if (t->at < t->have) return t->block[t->at];
    if (t->is_over || t->is_ended) return t->is_over ? OVER : END;
    t->have = fread(t->block, 1, sizeof t->block, t->file);
    t->at = 0;
    if (ferror(t->file)) give_up(t->path, "cannot be read");
    sha_add(&t->sha, t->block, t->have);
    t->is_ended = t->have == 0;
    if ((int64_t)t->have > max_bytes - t->read) {
        t->is_over = 1;
        t->have = (size_t)(max_bytes - t->read);
    }
    t->read += (int64_t)t->have;
    return t->have ? t->block[0] : t->is_over ? OVER : END;
}

/* The same, but what is over is refused. */
static int look_within(Tokens *t) {
    const int c = look(t);
    if (c == OVER) too_many(t, max_bytes, "bytes");
    return c;
}

/* Append a byte to the token. */
static void append(Tokens *t, int c) {
    if (t->length + 2 > t->room) {
        t->room = 2 * t->room + 64;
        t->token = room_for(t->token, t->room, 1);
    }
    t->token[t->length++] = (char)c;
    t->token[t->length] = 0;
}

static void check_length(const Tokens *t) {
    if ((int64_t)t->length > 2 * max_digits + 16) too_long(t);
}

static int is_digit(int c) { return c >= '0' && c <= '9'; }

static int is_hexadecimal(int c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/* Return the byte that the next token begins with, or END. */
static int peek(Tokens *t) {
    int c;
    while ((c = look_within(t)) == ' ' || c == '\t' || c == '\n' || c == '\r') t->at++;
    t->start = t->read - (int64_t)t->have + (int64_t)t->at;
    return c;
}

static void escape(Tokens *t) {
    char found[7] = "\\";
    int i, c, count = 2;
    t->at++;
    for (i = 1; i < count; i++) {
        c = look_within(t);
        if (i == 1 && c == 'u') count = 6;
        else if (i == 1 ? c == END || !c || !strchr("\"\\/bfnrt", c) : !is_hexadecimal(c)) wrong(t, "a token");
        found[i] = (char)c;
        t->at++;
    }
    for (i = 0; i < count; i++) append(t, found[i]);
    check_length(t);
}

/* Read the next token; return its first byte, END at the end. */
static int next(Tokens *t) {
    const int first = peek(t);
    int c;
    t->length = 0;
    append(t, first == END ? 0 : first);
    if (first == END) return END;
    if (first == '"') {
        t->at++;
        check_length(t);
        while ((c = look_within(t)) != '"') {
            if (c == '\\') {
                escape(t);
            } else {
                if (c < ' ' || c > '~') wrong(t, "a token");
                t->at++;
                append(t, c);
                check_length(t);
            }
        }
        t->at++;
    } else if (first == '-' || is_digit(first)) {
        t->at++;
        check_length(t);
        while (is_digit(c = look_within(t))) {
            t->at++;
            append(t, c);
            check_length(t);
        }
    } else if (strchr("[]{}:,", first) && first) {
        t->at++;
    } else {
        wrong(t, "a token");
    }
    return first;
}

static void expect(Tokens *t, int c) {
    const char text[2] = {(char)c, 0};
    if (next(t) != c) wrong(t, text);
}

static void count_items(Tokens *t) {
    if (++t->items > max_items) too_many(t, max_items, "items");
}

/* Begin a list; return whether it has an item. */
static int list_begins(Tokens *t) {
    expect(t, '[');
    if (peek(t) == ']') {
        next(t);
        return 0;
    }
    count_items(t);
    return 1;
}

/* Go on in a list; return whether there is another item. */
static int list_goes_on(Tokens *t) {
    const int c = next(t);
    if (c == ']') return 0;
    if (c != ',') wrong(t, ", or ]");
    count_items(t);
    return 1;
}

/* Read a string; return it. */
static const char *string(Tokens *t) {
    if (next(t) != '"') wrong(t, "a string");
    return t->token + 1;
}

static char *kept(const char *text) {
    const size_t size = strlen(text) + 1;
    return memcpy(room_for(NULL, size, 1), text, size);
}

/* Whether text is 0 or digits that do not begin with 0. */
static int is_whole(const char *text) {
    size_t i;
    for (i = 0; text[i]; i++)
        if (!is_digit(text[i])) return 0;
    return i > 0 && (text[0] != '0' || i == 1);
}

static size_t digits_at(const char *text) {
    size_t i = 0;
    while (is_digit(text[i])) i++;
    return i;
}

/* Read an integer, or a string that is an integer, decimal or fraction. */
static void scalar(Tokens *t, Ratio *r) {
    const int first = next(t);
    const char *at = t->token + (first == '"'), *whole, *part = "", *under = "";
    size_t whole_count, part_count = 0, under_count = 0, shift = 0, i;
    int is_negative, is_down = 0;
    if (first != '"' && !is_whole(at + (*at == '-'))) wrong(t, "a scalar");
    is_negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    whole = at;
    whole_count = digits_at(at);
    at += whole_count;
    if (*at == '/' && whole_count) {
        under = at + 1;
        under_count = digits_at(under);
        if (!under_count || under[under_count]) wrong(t, "a scalar");
    } else {
        size_t exponent_count = 0;
        if (*at == '.') {
            part = at + 1;
            part_count = digits_at(part);
            at = part + part_count;
        }
        if (*at == 'e' || *at == 'E') {
            at++;
            is_down = *at == '-';
            if (*at == '-' || *at == '+') at++;
            exponent_count = digits_at(at);
            if (!exponent_count) wrong(t, "a scalar");
            for (i = 0; i < exponent_count && i < 9; i++) shift = shift * 10 + (size_t)(at[i] - '0');
            at += exponent_count;
        }
        if (*at || !(whole_count + part_count)) wrong(t, "a scalar");
        if (exponent_count > 9) too_long(t);
    }
    if (whole_count + part_count + shift > (size_t)max_digits || under_count > (size_t)max_digits) too_long(t);
    set_small(&r->over, 0);
    append_digits(&r->over, whole, whole_count);
    append_digits(&r->over, part, part_count);
    if (is_negative) r->over.sign = -r->over.sign;
    set_small(&r->under, under_count ? 0 : 1);
    append_digits(&r->under, under, under_count);
    if (!r->under.sign) wrong(t, "a denominator that is not zero");
    if (!is_down && shift > part_count) {
        const int sign = r->over.sign;
        append_zeros(&r->over, shift - part_count);
        r->over.sign = sign;
    } else {
        append_zeros(&r->under, is_down ? shift + part_count : part_count - shift);
    }
}

typedef struct {
    Ratio value;
    char *text;
} Claim;

/* Read a scalar that is a string. */
static void claim(Tokens *t, Claim *found) {
    scalar(t, &found->value);
    if (t->token[0] != '"') wrong(t, "a string");
    found->text = kept(t->token + 1);
}

typedef struct {
    Big x, y, w; /* (x/w, y/w), w > 0 */
} Point;

typedef struct {
    Point *at;
    size_t count, room;
} Points;

static void points(Tokens *t, Points *found) {
    static Ratio x, y;
    int more;
    for (more = list_begins(t); more; more = list_goes_on(t)) {
        Point *p;
        if (found->count == found->room) {
            found->room = 2 * found->room + 16;
            found->at = room_for(found->at, found->room, sizeof *found->at);
        }
        p = &found->at[found->count];
        memset(p, 0, sizeof *p);
        expect(t, '[');
        scalar(t, &x);
        expect(t, ',');
        scalar(t, &y);
        expect(t, ']');
        if (compare(&x.under, &y.under) == 0) {
            copy(&p->x, &x.over);
            copy(&p->y, &y.over);
            copy(&p->w, &x.under);
        } else {
            multiply(&p->x, &x.over, &y.under);
            multiply(&p->y, &y.over, &x.under);
            multiply(&p->w, &x.under, &y.under);
        }
        found->count++;
    }
}

typedef struct {
    int64_t *at;
    size_t count, room;
} Indices;

static void push(Indices *list, int64_t value) {
    if (list->count == list->room) {
        list->room = 2 * list->room + 16;
        list->at = room_for(list->at, list->room, sizeof *list->at);
    }
    list->at[list->count++] = value;
}

static void indices(Tokens *t, Indices *found) {
    int more;
    for (more = list_begins(t); more; more = list_goes_on(t)) {
        int64_t value = 0;
        size_t i;
        next(t);
        if (!is_whole(t->token) || t->length > 18) wrong(t, "an index");
        for (i = 0; i < t->length; i++) value = value * 10 + (t->token[i] - '0');
        push(found, value);
    }
}

typedef struct {
    Indices flat, start; /* cycle i is flat[start[i]] to flat[start[i + 1] - 1] */
    size_t count;
} Cycles;

static void cycles(Tokens *t, Cycles *found) {
    int more;
    push(&found->start, 0);
    for (more = list_begins(t); more; more = list_goes_on(t)) {
        indices(t, &found->flat);
        push(&found->start, (int64_t)found->flat.count);
        found->count++;
    }
}

/* Read on to the value of the next of the keys; return its number, -1 after the last. `seen` has a bit for each. */
static int key(Tokens *t, const char *const *keys, unsigned *seen) {
    int c, i;
    if (!*seen) {
        expect(t, '{');
    } else if ((c = next(t)) == '}') {
        if (next(t) != END) wrong(t, "the end");
        for (i = 0; keys[i]; i++)
            if (!(*seen >> i & 1) && strcmp(keys[i], "holes") && strcmp(keys[i], "name"))
                refuse("format", "%s: no %s", t->name, keys[i]);
        return -1;
    } else if (c != ',') {
        wrong(t, ", or }");
    }
    c = next(t);
    for (i = 0; keys[i]; i++)
        if (c == '"' && !strcmp(t->token + 1, keys[i]) && !(*seen >> i & 1)) {
            *seen |= 1u << i;
            expect(t, ':');
            return i;
        }
    wrong(t, "another key");
}

static void format(Tokens *t, const char *quoted) {
    if (next(t) != '"' || strncmp(t->token, quoted, t->length) || strlen(quoted) != t->length + 1) wrong(t, quoted);
}

typedef struct {
    Points vertices, holes;
    Cycles edges;
    char sha256[65];
} Pslg;

static void read_pslg(Tokens *t, Pslg *found) {
    static const char *const keys[] = {"format", "vertices", "edges", "holes", "name", NULL};
    unsigned seen = 0;
    int i;
    while ((i = key(t, keys, &seen)) >= 0)
        switch (i) {
        case 0: format(t, "\"exactmesh-pslg/1\""); break;
        case 1: points(t, &found->vertices); break;
        case 2: cycles(t, &found->edges); break;
        case 3: points(t, &found->holes); break;
        default: string(t);
        }
    sha_text(&t->sha, found->sha256);
}

typedef struct {
    char *kind;
    Points vertices;
    Cycles faces;
    char sha256[65];
} Mesh;

static void read_mesh(Tokens *t, Mesh *found) {
    static const char *const keys[] = {"format", "kind", "vertices", "faces", NULL};
    unsigned seen = 0;
    int i;
    while ((i = key(t, keys, &seen)) >= 0)
        switch (i) {
        case 0: format(t, "\"exactmesh-mesh/1\""); break;
        case 1: found->kind = kept(string(t)); break;
        case 2: points(t, &found->vertices); break;
        default: cycles(t, &found->faces);
        }
    sha_text(&t->sha, found->sha256);
}

typedef struct {
    char *pslg_sha256, *mesh_sha256;
    Claim mfs_squared_at_least, mfs_at_least, input_mfs_squared_at_most, degradation_squared_at_most;
    Claim degradation_at_most;
    Indices witness, hole_faces;
    Points vertices;
    Cycles faces;
} Certificate;

static void read_certificate(Tokens *t, Certificate *found) {
    static const char *const keys[] = {
        "format", "pslg_sha256", "mesh_sha256", "mfs_squared_at_least", "mfs_at_least", "input_mfs_squared_at_most",
        "degradation_squared_at_most", "degradation_at_most", "witness", "hole_faces", "vertices", "faces", NULL};
    unsigned seen = 0;
    int i;
    while ((i = key(t, keys, &seen)) >= 0)
        switch (i) {
        case 0: format(t, "\"exactmesh-certificate/1\""); break;
        case 1: found->pslg_sha256 = kept(string(t)); break;
        case 2: found->mesh_sha256 = kept(string(t)); break;
        case 3: claim(t, &found->mfs_squared_at_least); break;
        case 4: claim(t, &found->mfs_at_least); break;
        case 5: claim(t, &found->input_mfs_squared_at_most); break;
        case 6: claim(t, &found->degradation_squared_at_most); break;
        case 7: claim(t, &found->degradation_at_most); break;
        case 8: indices(t, &found->witness); break;
        case 9: indices(t, &found->hole_faces); break;
        case 10: points(t, &found->vertices); break;
        default: cycles(t, &found->faces);
        }
}

/* --- geometry: signs of polynomials --- */

typedef struct {
    Big x, y;
} Vector;

/* r = a - b, times the positive a.w b.w */
static void minus(Vector *r, const Point *a, const Point *b) {
    combine(&r->x, &a->x, &b->w, -1, &b->x, &a->w);
    combine(&r->y, &a->y, &b->w, -1, &b->y, &a->w);
}

static void dot(Big *r, const Vector *u, const Vector *v) { combine(r, &u->x, &v->x, 1, &u->y, &v->y); }

static int is_ahead(const Point *a, const Point *b, const Point *c) {
    static Vector u, v;
    static Big product;
    minus(&u, b, a);
    minus(&v, c, b);
    dot(&product, &u, &v);
    return product.sign > 0;
}

/* Return 1, 0, -1 as a, b, c turn left, are collinear, or turn right. */
static int turn(const Point *a, const Point *b, const Point *c) {
    static Big minor, term, sum;
    combine(&minor, &b->y, &c->w, -1, &c->y, &b->w);
    multiply(&sum, &a->x, &minor);
    combine(&minor, &b->x, &c->w, -1, &c->x, &b->w);
    multiply(&term, &a->y, &minor);
    add(&sum, &sum, &term, -1);
    combine(&minor, &b->x, &c->y, -1, &c->x, &b->y);
    multiply(&term, &a->w, &minor);
    add(&sum, &sum, &term, 1);
    return sum.sign;
}

static int coincide(const Point *a, const Point *b) {
    static Vector difference;
    minus(&difference, a, b);
    return !difference.x.sign && !difference.y.sign;
}

/* r = the squared distance of t from the closed segment a b; a = b is allowed */
static void distance_squared(Ratio *r, const Point *t, const Point *a, const Point *b) {
    static Vector edge, from_a, from_b;
    static Big product, weight;
    minus(&edge, b, a);
    minus(&from_a, t, a);
    dot(&product, &edge, &from_a);
    if (product.sign <= 0) {
        dot(&r->over, &from_a, &from_a);
        multiply(&weight, &a->w, &t->w);
        multiply(&r->under, &weight, &weight);
        return;
    }
    minus(&from_b, t, b);
    dot(&product, &edge, &from_b);
    if (product.sign >= 0) {
        dot(&r->over, &from_b, &from_b);
        multiply(&weight, &b->w, &t->w);
        multiply(&r->under, &weight, &weight);
        return;
    }
    /* `edge` is too long by a.w b.w, `from_a` by a.w t.w: what is left is (a.w t.w)^2. */
    combine(&product, &edge.x, &from_a.y, -1, &edge.y, &from_a.x);
    multiply(&r->over, &product, &product);
    multiply(&weight, &a->w, &t->w);
    multiply(&product, &weight, &weight);
    dot(&weight, &edge, &edge);
    multiply(&r->under, &weight, &product);
}

static int is_nearer(const Point *t, const Point *a, const Point *b, const Ratio *bound) {
    static Ratio distance;
    distance_squared(&distance, t, a, b);
    return is_less(&distance, bound);
}

/* --- the clauses; vertices and faces of the mesh come before those of the rest, which the certificate holds --- */

typedef struct {
    int64_t key, half_edge;
} Keyed;

static Pslg pslg;
static Mesh mesh;
static Certificate certificate;
static int64_t given, watched, size; /* vertices of the input, of the mesh, of all */
static int64_t meshed, face_count;   /* faces of the mesh, of all */
static int64_t half_edges, *origin, *start, *face_of, *twin;
static Keyed *keyed;
static unsigned char *is_input, *reached;
static int64_t sides[4], side_count;

static const Point *point(int64_t v) {
    return v < watched ? &mesh.vertices.at[v] : &certificate.vertices.at[v - watched];
}

static int64_t target(int64_t h) {
    const int64_t face = face_of[h];
    return h + 1 < start[face + 1] ? origin[h + 1] : origin[start[face]];
}

static void refuse_face(const char *clause, int64_t face, const char *what) NO_RETURN;
static void refuse_face(const char *clause, int64_t face, const char *what) {
    const int is_rest = face >= meshed;
    refuse(clause, "%s face %lld%s", is_rest ? "rest" : "mesh", (long long)(face - (is_rest ? meshed : 0)), what);
}

static void refuse_edge(const char *clause, int64_t h) NO_RETURN;
static void refuse_edge(const char *clause, int64_t h) {
    refuse(clause, "edge [%lld, %lld]", (long long)origin[h], (long long)target(h));
}

/* Each list has between `least` and `most` (0: any number of) indices below `bound`. */
static void check_indices(const Cycles *rows, const char *name, int64_t bound, int64_t least, int64_t most) {
    size_t i;
    int64_t h;
    for (i = 0; i < rows->count; i++) {
        const int64_t from = rows->start.at[i], to = rows->start.at[i + 1];
        int is_wrong = to - from < least || (most && to - from > most);
        for (h = from; h < to; h++) is_wrong |= rows->flat.at[h] >= bound;
        if (is_wrong) refuse("index", "%s %lld", name, (long long)i);
    }
}

/* The files belong together; indices are in range. */
static void check_files(void) {
    size_t i;
    int is_wrong;
    if (strcmp(certificate.pslg_sha256, pslg.sha256)) refuse("hash", "PSLG");
    if (strcmp(certificate.mesh_sha256, mesh.sha256)) refuse("hash", "MESH");
    if (strcmp(mesh.kind, "classic") && strcmp(mesh.kind, "nonproper") && strcmp(mesh.kind, "proper"))
        refuse("kind", "MESH");
    check_indices(&pslg.edges, "PSLG: edge", given, 2, 2);
    check_indices(&mesh.faces, "MESH: face", watched, 3, 0);
    check_indices(&certificate.faces, "CERTIFICATE: face", size, 3, 0);
    is_wrong = certificate.witness.count != 3;
    for (i = 0; i < certificate.witness.count; i++) is_wrong |= certificate.witness.at[i] >= given;
    if (is_wrong) refuse("index", "CERTIFICATE: witness");
    is_wrong = certificate.hole_faces.count != pslg.holes.count;
    for (i = 0; i < certificate.hole_faces.count; i++)
        is_wrong |= certificate.hole_faces.at[i] >= (int64_t)certificate.faces.count;
    if (is_wrong) refuse("index", "CERTIFICATE: hole_faces");
}

/* The input's vertices come first in the mesh, unchanged; a classic mesh has no others. */
static void check_input_vertices(void) {
    int64_t v;
    for (v = 0; v < given; v++)
        if (v >= watched || !coincide(&pslg.vertices.at[v], point(v)))
            refuse("input-vertices", "vertex %lld", (long long)v);
    if (!strcmp(mesh.kind, "classic") && watched > given) refuse("steiner", "vertex %lld", (long long)given);
}

/* Put the places of the three left turns of a face that goes straight on elsewhere; return whether it is such. */
static int corners_of(int64_t face, int64_t corners[3]) {
    const int64_t *cycle = origin + start[face];
    const int64_t count = start[face + 1] - start[face];
    int64_t i;
    int found = 0;
    if (count == 3) {
        for (i = 0; i < 3; i++) corners[i] = i;
        return turn(point(cycle[0]), point(cycle[1]), point(cycle[2])) > 0;
    }
    for (i = 0; i < count; i++) {
        const Point *before = point(cycle[i ? i - 1 : count - 1]), *here = point(cycle[i]);
        const Point *after = point(cycle[i + 1 < count ? i + 1 : 0]);
        const int sign = turn(before, here, after);
        if (sign < 0 || (sign > 0 && found == 3) || (!sign && !is_ahead(before, here, after))) return 0;
        if (sign > 0) corners[found++] = i;
    }
    return found == 3;
}

/* Whether each vertex of the mesh on the face is far enough from its neighbours on the cycle and from the sides of the
 * triangle that do not contain it. */
static int has_room(int64_t face, const int64_t corners[3]) {
    const int64_t *cycle = origin + start[face];
    const int64_t count = start[face + 1] - start[face];
    const Ratio *bound = &certificate.mfs_squared_at_least.value;
    int64_t i, place;
    for (i = 0; i < 3; i++) {
        const int64_t first = corners[i], last = corners[(i + 1) % 3], other = corners[(i + 2) % 3];
        for (place = first; place < (last > first ? last : last + count); place++) {
            const int64_t v = cycle[place % count];
            if (v >= watched) continue;
            if (is_nearer(point(v), point(cycle[last]), point(cycle[other]), bound)) return 0;
            if (place > first && is_nearer(point(v), point(cycle[other]), point(cycle[first]), bound)) return 0;
        }
    }
    for (i = 0; i < count && count > 3; i++) {
        const int64_t u = cycle[i ? i - 1 : count - 1], v = cycle[i];
        if ((u < watched || v < watched) && is_nearer(point(u), point(v), point(v), bound)) return 0;
    }
    return 1;
}

/* Each face is a counter-clockwise triangle, and leaves room around each vertex of the mesh on it. */
static void check_faces(void) {
    int64_t face, corners[3];
    if (!meshed) refuse("domain", "MESH: no face");
    if (certificate.mfs_squared_at_least.value.over.sign <= 0) refuse("bound", "mfs_squared_at_least is not positive");
    for (face = 0; face < face_count; face++) {
        if (!corners_of(face, corners)) refuse_face("face-shape", face, "");
        if (start[face + 1] - start[face] > 3 && face < meshed && strcmp(mesh.kind, "nonproper"))
            refuse_face("face-size", face, "");
        if (!has_room(face, corners)) refuse_face("feature", face, "");
    }
}

/* The first four vertices of the rest are an upright rectangle, counter-clockwise from the lower left. */
static void check_box(void) {
    static const int signs[3][2] = {{1, 0}, {0, 1}, {-1, 0}};
    static Vector step;
    const Point *corner = certificate.vertices.at;
    int i, is_wrong = certificate.vertices.count < 4;
    for (i = 0; i < 3 && !is_wrong; i++) {
        minus(&step, &corner[i + 1], &corner[i]);
        is_wrong = step.x.sign != signs[i][0] || step.y.sign != signs[i][1];
    }
    if (!is_wrong) {
        minus(&step, &corner[0], &corner[3]);
        is_wrong = step.x.sign;
    }
    if (is_wrong) refuse("box", "CERTIFICATE: vertices");
}

static int by_key(const void *left, const void *right) {
    const Keyed *a = left, *b = right;
    if (a->key != b->key) return a->key < b->key ? -1 : 1;
    return a->half_edge < b->half_edge ? -1 : a->half_edge > b->half_edge;
}

/* Each directed edge occurs once, and so does its reverse, but for the four sides of the box. */
static void check_tiling(void) {
    int64_t h, i;
    for (h = 0; h < half_edges; h++) {
        const int64_t u = origin[h], v = target(h);
        keyed[h].key = u < v ? 2 * (u * size + v) : 2 * (v * size + u) + 1;
        keyed[h].half_edge = h;
        twin[h] = -1;
    }
    qsort(keyed, (size_t)half_edges, sizeof *keyed, by_key);
    for (i = 0; i < half_edges; i++) {
        const int64_t key_here = keyed[i].key;
        const int64_t after = i + 1 < half_edges ? keyed[i + 1].key : -1;
        const int64_t second = i + 2 < half_edges ? keyed[i + 2].key : -1;
        h = keyed[i].half_edge;
        if (after == key_here || (after == (key_here ^ 1) && second == after)) refuse_edge("overlap", h);
        if (after == (key_here ^ 1)) {
            const int64_t g = keyed[++i].half_edge;
            twin[h] = g;
            twin[g] = h;
        } else {
            const int64_t u = origin[h] - watched, v = target(h) - watched;
            if (u < 0 || u >= 4 || v != (u + 1) % 4) refuse_edge("boundary", h);
            sides[side_count++] = h; /* at most four: no directed edge occurs twice */
        }
    }
}

/* Each vertex is on a face, each new one of the mesh on a face of the mesh. */
static void check_use(void) {
    static unsigned char *used; /* in a static place, so that it is no leak when the program ends early */
    int64_t h;
    used = memset(room_for(NULL, (size_t)size, 1), 0, (size_t)size);
    for (h = 0; h < half_edges; h++)
        if (h < start[meshed] || origin[h] < given || origin[h] >= watched) used[origin[h]] = 1;
    for (h = 0; h < size; h++)
        if (!used[h]) refuse("unused-vertex", "vertex %lld", (long long)h);
}

/* Return the place of the first of the sorted keys that is not less. */
static int64_t place_of(int64_t wanted) {
    int64_t low = 0, high = half_edges;
    while (low < high) {
        const int64_t middle = low + (high - low) / 2;
        if (keyed[middle].key < wanted) low = middle + 1;
        else high = middle;
    }
    return low;
}

/* Each edge of the input is an edge of the tiling, and no two are the same. */
static void check_input_edges(void) {
    size_t e;
    for (e = 0; e < pslg.edges.count; e++) {
        const int64_t *ends = pslg.edges.flat.at + 2 * e;
        const int64_t u = ends[0] < ends[1] ? ends[0] : ends[1], v = ends[0] < ends[1] ? ends[1] : ends[0];
        const int64_t wanted = 2 * (u * size + v), place = place_of(wanted);
        int64_t h;
        if (place == half_edges || keyed[place].key != wanted) refuse("input-edge", "edge %lld", (long long)e);
        h = keyed[place].half_edge;
        if (is_input[h]) refuse("repeated-edge", "edge %lld", (long long)e);
        is_input[h] = is_input[twin[h]] = 1; /* no side of the box, whose ends are not the input's */
    }
}

/* Only edges of the input part mesh and rest. */
static void check_border(void) {
    int64_t h;
    for (h = 0; h < start[meshed]; h++)
        if (twin[h] >= start[meshed] && !is_input[h]) refuse_edge("border", h);
}

/* Mark the faces of the rest that are reached from one, marked or not, without crossing the input. */
static void flood(int64_t from, unsigned char mark) {
    static Indices waiting;
    reached[from] = mark;
    push(&waiting, from);
    while (waiting.count) {
        const int64_t face = waiting.at[--waiting.count];
        int64_t h;
        for (h = start[face]; h < start[face + 1]; h++)
            if (twin[h] >= 0 && !is_input[h] && !reached[face_of[twin[h]]]) {
                reached[face_of[twin[h]]] = mark;
                push(&waiting, face_of[twin[h]]);
            }
    }
}

/* Whether p is in the closed face, and neither on an edge of the input nor one of its vertices. */
static int is_inside(const Point *p, int64_t face) {
    static Vector from_a, from_b;
    static Big product;
    int64_t h;
    for (h = start[face]; h < start[face + 1]; h++) {
        const Point *a = point(origin[h]), *b = point(target(h));
        const int sign = turn(a, b, p);
        minus(&from_a, p, a);
        if (sign < 0 || (origin[h] < given && !from_a.x.sign && !from_a.y.sign)) return 0;
        minus(&from_b, p, b);
        dot(&product, &from_a, &from_b);
        if (sign == 0 && is_input[h] && product.sign <= 0) return 0;
    }
    return 1;
}

/* The rest is what is reached from the box and from hole points without crossing the input. */
static void check_holes(void) {
    int64_t face;
    size_t i;
    for (i = 0; i < (size_t)side_count; i++) flood(face_of[sides[i]], 1);
    for (i = 0; i < pslg.holes.count; i++) {
        const long long number = (long long)certificate.hole_faces.at[i];
        face = meshed + certificate.hole_faces.at[i];
        if (!is_inside(&pslg.holes.at[i], face))
            refuse("hole", "hole %lld: not inside rest face %lld", (long long)i, number);
        if (reached[face] == 1) refuse("hole", "hole %lld: outside", (long long)i);
        flood(face, 2);
    }
    for (face = meshed; face < face_count; face++)
        if (!reached[face]) refuse_face("domain", face, ": neither outside nor in a hole");
}

/* r = a^2 */
static void square(Ratio *r, const Ratio *a) {
    multiply(&r->over, &a->over, &a->over);
    multiply(&r->under, &a->under, &a->under);
}

/* The witness is a pair of the input as near as stated; the degradation and the decimals follow. */
static void check_claims(void) {
    static Ratio value;
    const int64_t v = certificate.witness.at[0], a = certificate.witness.at[1], b = certificate.witness.at[2];
    const Ratio *bound = &certificate.mfs_squared_at_least.value, *input = &certificate.input_mfs_squared_at_most.value;
    const Ratio *degradation = &certificate.degradation_squared_at_most.value;
    int is_edge = a == b;
    size_t e;
    for (e = 0; e < pslg.edges.count; e++) {
        const int64_t *ends = pslg.edges.flat.at + 2 * e;
        is_edge |= (ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a);
    }
    if (v == a || v == b || !is_edge) refuse("witness", "no pair of the input");
    distance_squared(&value, point(v), point(a), point(b));
    if (is_less(input, &value)) refuse("witness", "input_mfs_squared_at_most");
    multiply(&value.over, &input->over, &bound->under);
    multiply(&value.under, &input->under, &bound->over);
    if (is_less(degradation, &value)) refuse("claim", "degradation_squared_at_most");
    square(&value, &certificate.mfs_at_least.value);
    if (certificate.mfs_at_least.value.over.sign < 0 || is_less(bound, &value)) refuse("claim", "mfs_at_least");
    square(&value, &certificate.degradation_at_most.value);
    if (certificate.degradation_at_most.value.over.sign < 0 || is_less(&value, degradation))
        refuse("claim", "degradation_at_most");
}

/* Put the faces of mesh and certificate one after the other; half-edge h leads from origin[h] to the next vertex. */
static void join(void) {
    const size_t first = mesh.faces.flat.count, rest = certificate.faces.flat.count;
    int64_t face, h;
    given = (int64_t)pslg.vertices.count;
    watched = (int64_t)mesh.vertices.count;
    size = watched + (int64_t)certificate.vertices.count;
    meshed = (int64_t)mesh.faces.count;
    face_count = meshed + (int64_t)certificate.faces.count;
    half_edges = (int64_t)(first + rest);
    origin = room_for(NULL, first + rest + 1, sizeof *origin);
    if (first) memcpy(origin, mesh.faces.flat.at, first * sizeof *origin);
    if (rest) memcpy(origin + first, certificate.faces.flat.at, rest * sizeof *origin);
    start = room_for(NULL, (size_t)face_count + 1, sizeof *start);
    for (face = 0; face <= face_count; face++)
        start[face] = face <= meshed ? mesh.faces.start.at[face]
                                     : (int64_t)first + certificate.faces.start.at[face - meshed];
    face_of = room_for(NULL, first + rest + 1, sizeof *face_of);
    twin = room_for(NULL, first + rest + 1, sizeof *twin);
    keyed = room_for(NULL, first + rest + 1, sizeof *keyed);
    is_input = memset(room_for(NULL, first + rest + 1, 1), 0, first + rest + 1);
    reached = memset(room_for(NULL, (size_t)face_count + 1, 1), 0, (size_t)face_count + 1);
    for (face = 0; face < face_count; face++)
        for (h = start[face]; h < start[face + 1]; h++) face_of[h] = face;
}

static int usage(void) {
    fputs("usage: check PSLG MESH CERTIFICATE [--max-bytes N] [--max-digits N] [--max-items N]\n", stderr);
    return REFUSED;
}

int main(int count, char **values) {
    static const char *const names[] = {"PSLG", "MESH", "CERTIFICATE"};
    static Tokens files[3];
    const char *paths[3];
    int i, found = 0;
    for (i = 1; i < count; i++) {
        int64_t *limit = !strcmp(values[i], "--max-bytes")    ? &max_bytes
                         : !strcmp(values[i], "--max-digits") ? &max_digits
                         : !strcmp(values[i], "--max-items")  ? &max_items
                                                              : NULL;
        if (limit) {
            const char *text = ++i < count ? values[i] : "";
            const size_t length = strlen(text);
            if (!length || length > 9 || digits_at(text) != length) return usage();
            *limit = strtol(text, NULL, 10);
        } else if (found == 3 || values[i][0] == '-') {
            return usage();
        } else {
            paths[found++] = values[i];
        }
    }
    if (found < 3) return usage();
    for (i = 0; i < 3; i++) open_file(&files[i], names[i], paths[i]);
    for (i = 0; i < 3; i++) look(&files[i]); /* what cannot be read is told before any verdict */
    read_pslg(&files[0], &pslg);
    read_mesh(&files[1], &mesh);
    read_certificate(&files[2], &certificate);
    join();
    check_files();
    check_input_vertices();
    check_faces();
    check_box();
    check_tiling();
    check_use();
    check_input_edges();
    check_border();
    check_holes();
    check_claims();
    printf("VALID %s mesh: mfs_squared >= %s (mfs >= %s), degradation_squared <= %s (degradation <= %s)\n", mesh.kind,
           certificate.mfs_squared_at_least.text, certificate.mfs_at_least.text,
           certificate.degradation_squared_at_most.text, certificate.degradation_at_most.text);
    return fflush(stdout) ? REFUSED : VALID;
}
