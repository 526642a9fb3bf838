CREATE TABLE attempt (
    id INTEGER PRIMARY KEY,
    time_s INTEGER,             -- seconds since 1970 began, UTC; NULL: nobody knows
    player TEXT NOT NULL,
    family TEXT NOT NULL,
    topic TEXT NOT NULL,
    seed INTEGER NOT NULL,      -- the 64 bits of an unsigned number
    number INTEGER NOT NULL,    -- place in the round, from 1
    question TEXT NOT NULL,     -- JSON, with the units in the names
    answer TEXT NOT NULL,
    truth TEXT NOT NULL,
    error_deg REAL,             -- NULL: no angle to be off
    credit REAL NOT NULL,       -- 0 to 1
    is_right INTEGER NOT NULL,  -- 0 or 1
    confidence TEXT,            -- guess, think-so, sure; NULL: not asked
    misconception TEXT          -- its name in files; NULL: none
) STRICT;

CREATE INDEX attempt_of_player ON attempt (player);

CREATE TABLE star (
    player TEXT NOT NULL,
    pack TEXT NOT NULL,
    level TEXT NOT NULL,
    stars INTEGER NOT NULL,     -- 1 to 3
    PRIMARY KEY (player, pack, level)
) STRICT, WITHOUT ROWID;
