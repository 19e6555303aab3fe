-- What the benches have measured (bench.h), as tables: medians with the smallest and the largest
-- value, ratios, from how many spheres on a tree pays, and how builds grow.
--
-- Started by tables.sh, which fills the table `measured`. A ratio is the median of the rounds' ratios, as
-- what else the machine does falls on all cases of a round: it can differ from the ratio of two medians.

-- ---- Medians and rounds --------------------------------------------------------------------------

-- Of an even number of values the two in the middle count: of n places those from n / 2 to n / 2 + 1.
CREATE VIEW medians AS
WITH placed AS (
    SELECT *, rowid AS line, row_number() OVER (PARTITION BY scene, what, quantity ORDER BY value) AS place,
           count(*) OVER (PARTITION BY scene, what, quantity) AS n
    FROM measured),
counted AS (SELECT scene, max(value) AS elements FROM measured WHERE quantity = 'elements' GROUP BY scene)
SELECT scene, elements, what, quantity, n, min(line) AS line, min(value) AS smallest, max(value) AS largest,
       avg(value) FILTER (WHERE 2 * place BETWEEN n AND n + 2) AS median
FROM placed LEFT JOIN counted USING (scene) GROUP BY scene, what, quantity ORDER BY line;

-- Embree's call with the smallest median, under a name of its own.
INSERT INTO measured
WITH best AS (
    SELECT scene, what, quantity, min(median) FROM medians WHERE what LIKE 'rtc%' AND quantity <> 'different'
    GROUP BY scene, quantity)
SELECT scene, 'Embree, best call', quantity, round, value FROM measured JOIN best USING (scene, what, quantity);

-- The median of each round.
CREATE TABLE rounds AS
WITH placed AS (
    SELECT *, row_number() OVER (PARTITION BY scene, what, quantity, round ORDER BY value) AS place,
           count(*) OVER (PARTITION BY scene, what, quantity, round) AS n
    FROM measured)
SELECT scene, what, quantity, round, avg(value) AS value
FROM placed WHERE 2 * place BETWEEN n AND n + 2 GROUP BY scene, what, quantity, round;

-- A scene of random spheres that move: for each frame its tree is built anew and copied to the device.
INSERT INTO measured
SELECT scene, what, 'moving frame', round, sum(value) FROM rounds
WHERE scene LIKE 'random:n=%' AND what IN ('naive', 'kd-tree', 'kd-tree by cost', 'tiles')
    AND quantity IN ('frame', 'build', 'copy')
GROUP BY scene, what, round ORDER BY length(scene), scene;
INSERT INTO rounds SELECT * FROM measured WHERE quantity = 'moving frame';

-- ---- Times ---------------------------------------------------------------------------------------

.mode box --wrap 0
.print Milliseconds: median (smallest to largest). A naive frame on a CPU may be a part of it, scaled.
SELECT scene, what, quantity, n AS times,
       printf(iif(median < 100, '%.4g (%.4g to %.4g)', '%.0f (%.0f to %.0f)'), median, smallest, largest) AS ms,
       iif(quantity = 'frame', printf('%.4g', 1e3 / median), NULL) AS 'a second',
       iif(quantity IN ('frame', 'search') AND rays > 0, printf('%.4g', rays / 1e3 / median), NULL) AS 'Mray/s'
FROM medians LEFT JOIN (SELECT scene, value AS rays FROM measured WHERE quantity = 'rays') USING (scene)
WHERE quantity IN ('frame', 'search', 'build', 'build on all threads', 'copy', 'moving frame');

-- ---- Ratios --------------------------------------------------------------------------------------

CREATE TABLE asked (quantity, dividend, divisor);
INSERT INTO asked VALUES
    ('frame', 'naive', 'kd-tree'),
    ('frame', 'kd-tree', 'tiles'),
    ('frame', 'kd-tree by cost', 'tiles'),
    ('frame', 'painter', 'tiles'),
    ('frame', 'cairo', 'tiles'),
    ('frame', 'rtcIntersect1', 'kd-tree'),
    ('frame', 'rtcIntersect1', 'kd-tree by cost'),
    ('frame', 'Embree, best call', 'tiles'),
    ('search', 'kd-tree', 'tiles'),
    ('search', 'Embree, best call', 'kd-tree'),
    ('search', 'Embree, best call', 'tiles'),
    ('build', 'kd-tree', 'Embree'),
    ('build on all threads', 'kd-tree', 'Embree'),
    ('build on all threads', 'kd-tree by cost', 'Embree'),
    ('moving frame', 'naive', 'kd-tree'),
    ('moving frame', 'naive', 'kd-tree by cost'),
    ('moving frame', 'naive', 'tiles');
-- Each kernel of lab 10 without a trick.
INSERT INTO asked
SELECT DISTINCT 'frame', without.what, 'with all tricks' FROM rounds AS without
JOIN rounds AS tricks USING (scene) WHERE tricks.what = 'with all tricks' AND without.what <> tricks.what;

INSERT INTO measured
SELECT scene, dividend || ' / ' || divisor, 'ratio: ' || quantity, round, above.value / below.value
FROM asked JOIN rounds AS above USING (quantity) JOIN rounds AS below USING (quantity, scene, round)
WHERE above.what = dividend AND below.what = divisor ORDER BY length(scene), scene;

.print How many times as long the first takes: median of the rounds (smallest to largest)
SELECT substr(quantity, 8) AS quantity, scene, what, printf('%.3g (%.3g to %.3g)', median, smallest, largest) AS ratio
FROM medians WHERE quantity LIKE 'ratio: %' ORDER BY quantity, what, line;

-- ---- Work of a ray -------------------------------------------------------------------------------

-- Operations are counted in the text of lab 07's and lab 05's kernels, without the making of rays and the
-- shading: +, -, *, sqrt and comparisons of numbers. A node: near_side() 2, children_on_ray() 5. A test:
-- intersect_sphere() 21, nearest_root() 6, the leaf's own comparison 1. A node has 16 bytes, as a sphere
-- has; the sphere's id has 4.
CREATE VIEW work AS
WITH counts AS (
    SELECT scene, max(value) FILTER (WHERE quantity = 'inner nodes') AS nodes,
           max(value) FILTER (WHERE quantity = 'leaves') AS leaves,
           max(value) FILTER (WHERE quantity = 'spheres asked') AS spheres,
           max(value) FILTER (WHERE quantity = 'steps of the slowest') AS slowest,
           max(value) FILTER (WHERE quantity = 'rays') AS rays
    FROM measured GROUP BY scene)
SELECT *, nodes + leaves + spheres AS steps, 16 * (nodes + leaves) + 20 * spheres AS bytes,
       7 * nodes + 28 * spheres AS operations
FROM counts WHERE nodes IS NOT NULL;

.print What a ray of lab 07's kernel reads and computes. Of 32 neighbours all take as many steps as the slowest.
.print Nodes and spheres are read again and again: what caches give, not what memory does.
SELECT scene, printf('%.2f', nodes) AS 'inner nodes', printf('%.2f', leaves) AS leaves,
       printf('%.2f', spheres) AS 'spheres asked', printf('%.1f', steps) AS steps,
       printf('%.1f', slowest) AS 'of slowest', printf('%.0f', bytes) AS bytes,
       printf('%.0f', operations) AS operations, printf('%.3g', bytes * rays / 1e6 / median) AS 'GB/s',
       printf('%.3g', operations * rays / 1e6 / median) AS 'Gop/s'
FROM work JOIN medians USING (scene) WHERE what = 'kd-tree' AND quantity = 'frame' ORDER BY line;

.print Pixels, or rays, that differ from the kd-tree's. Of what is not listed none differ.
SELECT scene, what, value AS different FROM measured WHERE quantity = 'different' AND value > 0;

-- ---- From how many spheres on --------------------------------------------------------------------

CREATE TABLE questions (answer, longer, longer_quantity, shorter, shorter_quantity);
INSERT INTO questions VALUES
    ('lab 06''s tree and lab 07''s kernel are faster than the naive kernel',
     'naive', 'moving frame', 'kd-tree', 'moving frame'),
    ('lab 08''s tree and lab 07''s kernel are faster than the naive kernel',
     'naive', 'moving frame', 'kd-tree by cost', 'moving frame'),
    ('lab 10''s tiles are faster than the naive kernel', 'naive', 'moving frame', 'tiles', 'moving frame'),
    ('lab 06''s tree is the better one for lab 07''s kernel',
     'kd-tree by cost', 'moving frame', 'kd-tree', 'moving frame'),
    ('lab 06''s tree takes longer to build than 1/60 s', 'kd-tree', 'build', '1/60 s', 'limit'),
    ('lab 06''s tree takes longer to build than 1/15 s', 'kd-tree', 'build', '1/15 s', 'limit'),
    ('lab 08''s tree takes longer to build than 1/60 s', 'kd-tree by cost', 'build', '1/60 s', 'limit'),
    ('lab 08''s tree takes longer to build than 1/15 s', 'kd-tree by cost', 'build', '1/15 s', 'limit'),
    ('a whole frame of lab 10''s tiles takes longer than 1/60 s', 'tiles', 'moving frame', '1/60 s', 'limit'),
    ('a whole frame of lab 10''s tiles takes longer than 1/15 s', 'tiles', 'moving frame', '1/15 s', 'limit');
INSERT INTO rounds
SELECT DISTINCT scene, column1, 'limit', round, 1e3 / column2 FROM rounds, (VALUES ('1/60 s', 60), ('1/15 s', 15))
WHERE quantity = 'moving frame';

-- Between two scenes the ratio is 1 on the straight line between them, where both axes are logarithmic. Of
-- several spans of one round, as of times that hardly differ, the longest counts, by its ends' ratio. One that
-- lasts to the most spheres that were measured has no end, and `first` and `last` of none are infinite.
CREATE TABLE spans AS
WITH ratios AS (
    SELECT answer, round, elements, long.value / short.value AS ratio
    FROM questions JOIN rounds AS long ON long.what = longer AND long.quantity = longer_quantity
    JOIN rounds AS short USING (scene, round)
    JOIN (SELECT scene, value AS elements FROM measured WHERE quantity = 'elements') USING (scene)
    WHERE short.what = shorter AND short.quantity = shorter_quantity AND scene LIKE 'random:n=%'),
steps AS (
    SELECT *, lag(ratio) OVER upwards AS ratio_before, lag(elements) OVER upwards AS elements_before
    FROM ratios WINDOW upwards AS (PARTITION BY answer, round ORDER BY elements)),
crossings AS (
    SELECT answer, round, ratio > 1 AS rises,
           coalesce(elements_before * pow(elements / elements_before,
                                          ln(ratio_before) / (ln(ratio_before) - ln(ratio))), elements) AS at
    FROM steps WHERE (ratio > 1) <> coalesce(ratio_before > 1, 0)),
ends AS (
    SELECT *, lead(at) OVER (PARTITION BY answer, round ORDER BY at) AS until FROM crossings),
longest AS (
    SELECT answer, round, at, until, max(coalesce(until, (SELECT max(elements) FROM ratios)) / at)
    FROM ends WHERE rises GROUP BY answer, round)
SELECT answer, round, coalesce(at, 9e999) AS first, coalesce(until, 9e999) AS last
FROM (SELECT DISTINCT answer, round FROM ratios) LEFT JOIN longest USING (answer, round);

-- Two digits, as more would say what was not measured.
INSERT INTO measured
SELECT '', answer, edge, round, coalesce(round(at / unit) * unit, at)
FROM (SELECT *, pow(10, floor(log10(at)) - 1) AS unit
      FROM (SELECT answer, 'from' AS edge, round, first AS at FROM spans
            UNION ALL SELECT answer, 'to', round, last FROM spans));
CREATE VIEW edges AS
SELECT what, quantity, line, printf('%.7g (%.7g to %.7g)', median, smallest, largest) AS number
FROM medians WHERE quantity IN ('from', 'to');

.print Spheres that move: from how many on, and up to how many, it is so (single rounds); Inf: never, or to the end
SELECT what AS 'it is so that', min(number) FILTER (WHERE quantity = 'from') AS 'from',
       min(number) FILTER (WHERE quantity = 'to') AS 'to'
FROM edges GROUP BY what ORDER BY line;

-- ---- How builds grow -----------------------------------------------------------------------------

-- Is it N log N, a N log2 N + b N, or N, b N? Both are fitted to what grows, so that the sum of the squares of
-- the relative deviations is the smallest: else the largest scenes alone would count. With x = N log2 N / value
-- and y = N / value, (a x + b y - 1)^2 is smallest where a xx + b xy = x and a xy + b yy = y, all of them sums.
CREATE TABLE laws AS
WITH points AS (
    SELECT what, quantity, elements AS n, elements * log2(elements) / median AS x, elements / median AS y
    FROM medians WHERE scene LIKE '% elements' AND quantity IN ('build', 'handed on')),
sums AS (
    SELECT what, quantity, sum(x) AS x, sum(y) AS y, sum(x * x) AS xx, sum(x * y) AS xy, sum(y * y) AS yy
    FROM points GROUP BY what, quantity),
factors AS (
    SELECT what, quantity, 'N log N' AS law, (x * yy - y * xy) / (xx * yy - xy * xy) AS a,
           (y * xx - x * xy) / (xx * yy - xy * xy) AS b FROM sums
    UNION ALL
    SELECT what, quantity, 'N', 0, y / yy FROM sums)
SELECT what, quantity, law, a, b, n, (a * log2(n) + b) * n AS value, abs(a * x + b * y - 1) AS off
FROM factors JOIN points USING (what, quantity);

INSERT INTO measured SELECT printf('%d elements', n), what, quantity || ', ' || law, 0, value FROM laws;

.print Building a tree over N elements: for each of them ns of processor time, how many nodes it is handed on to,
.print bytes of the finished tree, and the most bytes that the builder has asked for at once; elements of a leaf
SELECT what, printf('%d', elements) AS N,
       printf('%.0f', max(median) FILTER (WHERE quantity = 'build') * 1e6 / elements) AS ns,
       printf('%.1f', max(median) FILTER (WHERE quantity = 'handed on') / elements) AS 'handed on',
       printf('%.1f', max(median) FILTER (WHERE quantity = 'tree bytes') / elements) AS 'tree bytes',
       printf('%.1f', max(median) FILTER (WHERE quantity = 'peak bytes') / elements) AS 'peak bytes',
       printf('%.1f', max(median) FILTER (WHERE quantity = 'per leaf')) AS 'per leaf'
FROM medians WHERE scene LIKE '% elements' GROUP BY what, elements;

.print By which law does it grow, a N log2 N + b N or b N? Time in ns; `off by` is the farthest case.
SELECT quantity, what, law, printf('%.2f', a * unit) AS a, printf('%.2f', b * unit) AS b,
       printf('%.0f %%', 100 * max(off)) AS 'off by'
FROM laws JOIN (SELECT 'build' AS quantity, 1e6 AS unit UNION VALUES ('handed on', 1)) USING (quantity)
GROUP BY quantity, what, law;

.print From a save to the verdict of make watch, in ms: median (smallest to largest), processor time, and until PoCL has judged
SELECT substr(scene, 7) AS lab, what,
       max(printf('%.0f (%.0f to %.0f)', median, smallest, largest)) FILTER (WHERE quantity = 'verdict') AS verdict,
       max(printf('%.0f', median)) FILTER (WHERE quantity = 'verdict, processor') AS processor,
       max(printf('%.0f', median)) FILTER (WHERE quantity = 'round') AS PoCL,
       max(printf('%.0f', median)) FILTER (WHERE quantity = 'round, processor') AS 'PoCL, processor'
FROM medians WHERE scene LIKE 'watch %' GROUP BY scene, what ORDER BY scene, what DESC;
