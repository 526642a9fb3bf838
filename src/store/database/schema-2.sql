CREATE TABLE bookmark (
    player TEXT NOT NULL,
    chapter TEXT NOT NULL,      -- its id
    page TEXT,                  -- title of the page it is open at; NULL: the first
    alpha_deg REAL,             -- set last in its figures; NULL: never
    PRIMARY KEY (player, chapter)
) STRICT, WITHOUT ROWID;

CREATE TABLE page_seen (
    player TEXT NOT NULL,
    chapter TEXT NOT NULL,
    page TEXT NOT NULL,         -- its title
    asked TEXT,                 -- the checkpoint as it is written; NULL: not answered
    answer TEXT,                -- JSON, with the units in the names
    is_right INTEGER,           -- 0 or 1
    PRIMARY KEY (player, chapter, page)
) STRICT, WITHOUT ROWID;
