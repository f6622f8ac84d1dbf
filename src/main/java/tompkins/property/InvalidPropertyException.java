package tompkins.property;

/** A property has a value that it must not have. The message names the property, what is allowed, and the value. */
public final class InvalidPropertyException extends IllegalArgumentException {

    private static final long serialVersionUID = 1;

    private final String property;
    private final String problem;
    private final String allowed;
    private final boolean byItself;

    /**
     * Describes one value that is wrong, perhaps only in combination with the other properties.
     *
     * @param property name of the property, as in the scene file
     * @param allowed what is allowed, continuing the sentence "(property) must be ..."
     * @param value the value that was given
     */
    public InvalidPropertyException(String property, String allowed, Object value) {
        this(property, allowed, value, false);
    }

    /** As above; also says whether the value is wrong by itself, whatever the other properties are. */
    InvalidPropertyException(String property, String allowed, Object value, boolean byItself) {
        super(property + " " + problem(allowed, value));
        this.property = property;
        problem = problem(allowed, value);
        this.allowed = value instanceof Number ? allowed : null;
        this.byItself = byItself;
    }

    /** What is wrong with a part of something, reported for the whole: "scene[0] velocity must be ...". */
    public InvalidPropertyException(String whole, InvalidPropertyException part) {
        super(whole + ": " + part.getMessage(), part);
        property = whole;
        problem = part.getMessage();
        allowed = null;
        byItself = part.byItself;
    }

    private static String problem(String allowed, Object value) {
        String shown = value instanceof Double number ? NumberText.of(number) : String.valueOf(value);
        return ("must be " + allowed).replaceFirst("^must be not ", "must not be ") + ", was "
                + (shown.isEmpty() ? "\"\"" : shown);
    }

    /** The name of the property that is wrong, as in the scene file. */
    public String property() {
        return property;
    }

    /** Whether the value is wrong by itself, and not only in combination with another one. */
    public boolean isByItself() {
        return byItself;
    }

    /** The message without the name: what is allowed, and the value. */
    public String problem() {
        return problem;
    }

    /** As {@link #problem()}; if the value is a number, it is shown as somebody wrote it. */
    public String problem(String written) {
        return allowed == null ? problem : problem(allowed, written);
    }
}
