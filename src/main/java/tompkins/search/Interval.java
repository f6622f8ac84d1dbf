package tompkins.search;

/** Numbers from the least to the most. */
record Interval(double least, double most) {

    /** The numbers that this and another have in common. */
    Interval and(Interval other) {
        return new Interval(Math.max(least, other.least), Math.min(most, other.most));
    }

    /** The numbers from the least of this and another to the most of them. */
    Interval with(Interval other) {
        return new Interval(Math.min(least, other.least), Math.max(most, other.most));
    }

    Interval times(double factor) {
        return factor > 0 ? new Interval(least * factor, most * factor) : new Interval(most * factor, least * factor);
    }

    Interval minus(Interval other) {
        return new Interval(least - other.most, most - other.least);
    }
}
