-- What a carrom of database format 3 kept: a call at the table and a prediction in a level. Made by that
-- program; only the times are set.
BEGIN TRANSACTION;
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
INSERT INTO attempt VALUES(1,1795000000,'Ada','table','heavier-striker-by-offset',11,1,'{"direction_deg":90.0,"m1_g":15.0,"m2_g":5.5,"offset_mm":-4.01891,"r1_mm":20.65,"r2_mm":15.9,"restitution":1.0,"speed":3.954890726}','{"theta1_deg":-59.99999999999999,"theta2_deg":-59.99999999999999}','{"theta1_deg":-7.113672766633193,"theta2_deg":-6.312807873681752}',53.687192126318258544,0.0,0,NULL,NULL);
INSERT INTO attempt VALUES(2,1795086400,'Ada','level','equal-masses-by-offset',0,5,'{"direction_deg":50.0,"level":"square-corner","m1_g":15.0,"m2_g":15.0,"offset_mm":-1.060138,"pack":"first-hits","r1_mm":20.65,"r2_mm":15.9,"ray":"striker","restitution":1.0,"speed":2.366580883}','{"angle_deg":-59.99999999999999}','{"angle_deg":-88.33789457531937}',28.337894575319364065,0.0086692557151830905437,0,NULL,NULL);
CREATE TABLE star (
    player TEXT NOT NULL,
    pack TEXT NOT NULL,
    level TEXT NOT NULL,
    stars INTEGER NOT NULL,     -- 1 to 3
    PRIMARY KEY (player, pack, level)
) STRICT, WITHOUT ROWID;
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
CREATE INDEX attempt_of_player ON attempt (player);
COMMIT;
PRAGMA user_version = 3;
