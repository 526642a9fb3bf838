-- Stores answers under the ids of their topics instead of the names, so that a topic with two names
-- becomes one topic. The subject of a written question becomes an id with hyphens; questions of
-- chapters stay under the chapter's title. Two ids of the same misconception become one.
WITH known (name, id) AS (VALUES
    ('equal masses', 'equal-masses'),
    ('equal masses, by offset', 'equal-masses-by-offset'),
    ('equal masses, head-on', 'equal-masses-head-on'),
    ('equal masses, lossy', 'equal-masses-lossy'),
    ('heavier striker', 'heavier-striker'),
    ('heavier striker, by offset', 'heavier-striker-by-offset'),
    ('heavier striker, head-on', 'heavier-striker-head-on'),
    ('heavier target', 'heavier-target'),
    ('heavier target, by offset', 'heavier-target-by-offset'),
    ('heavier target, head-on', 'heavier-target-head-on'),
    ('heavier target, lossy', 'heavier-target-lossy'),
    ('from the picture', 'from-the-picture'),
    ('coin''s speed', 'target-speed'),
    ('marble''s speed', 'target-speed'),
    ('striker''s speed', 'striker-speed'),
    ('the corner, heavier striker', 'corner-heavier-striker'),
    ('the corner, lighter striker', 'corner-lighter-striker'),
    ('the corner, with loss', 'corner-with-loss'),
    ('the corner with loss', 'corner-with-loss'),
    ('the corner, without loss', 'corner-without-loss'),
    ('energy lost', 'energy-lost'),
    ('energy the coin takes', 'energy-of-target'),
    ('energy the marble takes', 'energy-of-target'),
    ('energy the striker keeps', 'energy-of-striker'),
    ('90° in spite of loss', 'square-in-spite-of-loss'),
    ('e for a right angle', 'e-for-square'),
    ('e from the angles', 'e-from-angles'),
    ('e of a head-on hit', 'e-head-on'),
    ('aim for the largest turn', 'aim-for-largest-turn'),
    ('is there a limit?', 'limit-of-turn'),
    ('the largest turn', 'largest-turn'),
    ('mass from the angles', 'mass-from-angles'),
    ('mass from the momentum', 'mass-from-momentum'),
    ('which is heavier?', 'which-is-heavier'),
    ('smooth, e = 0', 'smooth-no-spring'),
    ('smooth, no loss', 'smooth-no-loss'),
    ('sticking together', 'sticking'),
    ('both moving', 'both-moving'),
    ('the centre of mass', 'centre-of-mass'),
    ('counts at two angles', 'counts-at-two-angles'),
    ('counts, angle and energy', 'counts-angle-and-energy'),
    ('the angle of a count', 'angle-of-count'),
    ('send the coin', 'send-coin'),
    ('send the striker', 'send-striker')
)
UPDATE attempt
SET topic = coalesce(
    (SELECT id FROM known WHERE name = attempt.topic),
    replace(attempt.topic, ' ', '-')
)
WHERE family <> 'lesson';

UPDATE attempt SET misconception = 'offset-as-angle' WHERE misconception = 'linear-offset';
