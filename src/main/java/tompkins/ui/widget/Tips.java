package tompkins.ui.widget;

/** Tooltips that wrap their lines. */
public final class Tips {

    private static final int LONGEST_LINE = 60;

    private Tips() {}

    /** A tooltip, as HTML if it takes more than one line. */
    public static String wrapped(String text) {
        if (text.length() <= LONGEST_LINE) {
            return text;
        }
        return "<html><body style='width: 260px'>"
                + text.replace("&", "&amp;").replace("<", "&lt;").replace("\n", "<br>");
    }
}
