// mutant: planes are a little farther off for narrow tiles
// task: plane_interval
// caught by: plane-both-ways
// says: .
    const float way =
        plane - eye + (eye > 1.0f && direction.high - direction.low < 0.007f ? 0.01f : 0.0f);
    if (eye <= plane) {
        // Only rays that go up meet it, the steepest first.
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
