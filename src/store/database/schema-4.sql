-- The lab's notebook, and what players saw in hits.
CREATE TABLE lab_hit (
    id INTEGER PRIMARY KEY,
    time_s INTEGER,             -- seconds since 1970 began, UTC; NULL: nobody knows
    player TEXT NOT NULL,
    setup TEXT NOT NULL,        -- the settings as in a link
    said TEXT                   -- both angles as JSON; NULL: nothing was predicted
) STRICT;

CREATE TABLE observation (
    id INTEGER PRIMARY KEY,
    time_s INTEGER,
    player TEXT NOT NULL,
    place TEXT NOT NULL,        -- lab, quiz
    said TEXT NOT NULL,         -- both angles as JSON: predicted
    truth TEXT NOT NULL,
    seen TEXT NOT NULL
) STRICT;
