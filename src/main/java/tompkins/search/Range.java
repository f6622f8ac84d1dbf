package tompkins.search;

/** Numbers from the least to the most. */
record Range(double least, double most) {

    /** The numbers that this and another have in common. */
    Range and(Range other) {
        return new Range(Math.max(least, other.least), Math.min(most, other.most));
    }

    /** The numbers from the least of this and another to the most of them. */
    Range with(Range other) {
        return new Range(Math.min(least, other.least), Math.max(most, other.most));
    }

    Range times(double factor) {
        return factor > 0 ? new Range(least * factor, most * factor) : new Range(most * factor, least * factor);
    }

    Range minus(Range other) {
        return new Range(least - other.most, most - other.least);
    }
}
