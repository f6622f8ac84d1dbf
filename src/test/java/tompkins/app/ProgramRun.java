package tompkins.app;

import java.io.PrintWriter;
import java.io.StringWriter;

/** One run of the program inside the test: exit code and what it printed. */
record ProgramRun(int code, String out, String err) {

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
