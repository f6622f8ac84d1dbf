package tompkins.app;

import java.io.PrintWriter;
import java.io.StringWriter;

/** One run of the program inside the test: exit code and what it printed. */
record ProgramRun(int code, String out, String err) {

    /** A scene file for tests that need one, whichever it is. */
    static final String FIG1B = "scenes/fig1b.json";

    static ProgramRun of(Object... arguments) {
        String[] words = new String[arguments.length];
        for (int i = 0; i < words.length; i++) {
            words[i] = arguments[i].toString();
        }
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.run(new PrintWriter(out, true), new PrintWriter(err, true), words);
        return new ProgramRun(code, out.toString(), err.toString());
    }
}
