package tompkins;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Documents that tests write. */
public final class GeneratedDocument {

    private GeneratedDocument() {}

    /** Where a document lies. */
    public static Path file(String name) {
        return Path.of(System.getProperty("basedir", ""), "docs", name);
    }

    /** Where a resource of the tests lies that tests write. */
    public static Path resource(String name) {
        return Path.of(System.getProperty("basedir", ""), "src/test/resources", name);
    }

    /** Fails if a document is out of date, or writes it if that is wanted. */
    public static void assertUpToDate(String name, String current, Class<?> test) throws IOException {
        assertUpToDate(file(name), current, test);
    }

    /** Fails if a file is out of date, or writes it if that is wanted. */
    public static void assertUpToDate(Path file, String current, Class<?> test) throws IOException {
        if (Boolean.getBoolean("tompkins.regenerate")) {
            Files.writeString(file, current);
        }
        assertThat(Files.exists(file) ? Files.readString(file).replace("\r\n", "\n") : "")
                .as("%s is out of date; write it anew with: %s", file, command(test))
                .isEqualTo(current);
    }

    /** What makes a test write its document. */
    public static String command(Class<?> test) {
        return "mvn -q test -Dtest=" + test.getSimpleName() + " -Dtompkins.regenerate=true";
    }
}
