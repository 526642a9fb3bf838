INSERT INTO star (player, pack, level, stars)
    SELECT player, pack, level, stars FROM opened.star WHERE true
    ON CONFLICT DO UPDATE SET stars = max(stars, excluded.stars);
INSERT INTO bookmark (player, chapter, page, alpha_deg)
    SELECT player, chapter, page, alpha_deg FROM opened.bookmark WHERE true
    ON CONFLICT DO NOTHING;
INSERT INTO page_seen (player, chapter, page, asked, answer, is_right)
    SELECT player, chapter, page, asked, answer, is_right FROM opened.page_seen WHERE true
    ON CONFLICT DO UPDATE SET asked = excluded.asked, answer = excluded.answer,
        is_right = excluded.is_right
    WHERE page_seen.answer IS NULL AND excluded.answer IS NOT NULL;
INSERT INTO lab_hit (time_s, player, setup, said)
    SELECT time_s, player, setup, said FROM opened.lab_hit
    EXCEPT SELECT time_s, player, setup, said FROM lab_hit ORDER BY time_s;
INSERT INTO observation (time_s, player, place, said, truth, seen)
    SELECT time_s, player, place, said, truth, seen FROM opened.observation
    EXCEPT SELECT time_s, player, place, said, truth, seen FROM observation ORDER BY time_s;
