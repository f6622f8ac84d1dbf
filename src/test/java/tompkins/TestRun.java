package tompkins;

/** How much the tests try: usually what is quick, and with {@code -Dtompkins.tests=all} everything. */
public final class TestRun {

    /** Whether everything is tried. */
    public static final boolean THOROUGH = "all".equals(System.getProperty("tompkins.tests"));

    private TestRun() {}

    /** How many random cases to try: a few usually, many if everything is tried. */
    public static int cases(int usually, int thoroughly) {
        return THOROUGH ? thoroughly : usually;
    }
}
