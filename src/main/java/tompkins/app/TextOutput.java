package tompkins.app;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.stream.Stream;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;

/** The file into which a command can write text instead of printing it. */
final class TextOutput {

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "write into this file what would be printed, and print its name")
    private Path file;

    @Option(names = "--force", description = "replace a file that is there")
    private boolean force;

    @ArgGroup
    private Form form = new Form();

    /** How results are told, if not in words. */
    private static final class Form {

        @Option(
                names = "--json",
                description =
                        "print JSON with 17 significant digits; null where there is no number, or none that is finite")
        private boolean json;

        @Option(
                names = "--csv",
                description = "print a table with 17 significant digits; empty where there is no number")
        private boolean csv;
    }

    /** Whether results are told as JSON. */
    boolean isJson() {
        return form.json;
    }

    /** Whether results are told as a table with commas. */
    boolean isCsv() {
        return form.csv;
    }

    /**
     * Refuses a file that exists, is read by the command or cannot be written, before the work begins.
     *
     * @param scene the file of the studio
     */
    void check(Studio studio, Path scene) {
        if (file != null) {
            check(file, studio, scene);
        }
    }

    /** Refuses another such file. */
    void check(Path target, Studio studio, Path scene) {
        Photographer.requirePlace(target, force, NamedFile.ofScene(studio, scene));
    }

    /** Saves a scene file; unless it is to be replaced, a file that took its name meanwhile stays. */
    void save(Studio studio, Path target) throws IOException {
        StudioWriter.save(studio, target, force);
    }

    /**
     * Prints lines, or writes them into the file; unless it is to be replaced, a file that took its name meanwhile
     * stays. Once a printed line is lost, because nobody reads on, those behind it are not asked for.
     *
     * @throws FileException if it cannot be written
     */
    void write(PrintWriter printed, Stream<String> lines) throws IOException {
        if (file == null) {
            Iterator<String> each = lines.flatMap(String::lines).iterator();
            while (each.hasNext() && !printed.checkError()) {
                printed.println(each.next());
            }
            return;
        }
        Path place = PendingFile.save(file, force, stream -> {
            Writer out = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.UTF_8));
            for (Iterator<String> each = lines.iterator(); each.hasNext(); ) {
                out.write(each.next());
                out.write('\n');
            }
            out.flush();
        });
        printed.println(place.toAbsolutePath());
    }
}
