package tompkins.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FileFailureTest {

    private static final String ENCODING = "sun.jnu.encoding";
    private final String before = System.getProperty(ENCODING);

    @AfterEach
    void leaveTheEncoding() {
        System.setProperty(ENCODING, before);
    }

    @ParameterizedTest
    @CsvSource({
        "ANSI_X3.4-1968, B\u00e4r.obj, true",
        "ANSI_X3.4-1968, \ufffd\ufffd.obj, true",
        "ISO-8859-1, \u03b2.json, true",
        "ISO-8859-1, B\u00e4r.obj, false",
        "UTF-8, \u03b2.json, false",
        "UTF-8, half \ud83d, false",
        "ANSI_X3.4-1968, 'a\0\u00e4', false",
        "unheard-of, B\u00e4r.obj, false",
    })
    void lettersBeyondTheLocaleAreItsFault(String encoding, String name, boolean isLocale) {
        System.setProperty(ENCODING, encoding);

        String reason = FileFailure.reason(new InvalidPathException(name, "malformed"));

        assertThat(reason.equals("no file can have this name")).isNotEqualTo(isLocale);
        assertThat(reason.contains("the locale has no such letters")).isEqualTo(isLocale);
        assertThat(reason.contains("LC_ALL=C.UTF-8")).isEqualTo(isLocale);
    }

    /** Libraries wrap it in failures to read; it says nothing about the file. */
    @Test
    void memoryThatRanOutIsNoFaultOfTheFile() {
        OutOfMemoryError full = new OutOfMemoryError("Java heap space");
        IOException wrapped = new IOException("reading", new RuntimeException(full));
        assertThatThrownBy(() -> FileException.cannotRead("a.png", wrapped)).isSameAs(full);
        assertThatThrownBy(() -> FileException.cannotWrite("a.png", wrapped)).isSameAs(full);
        assertThat(FileException.cannotRead("a.png", new IOException("reading", new IOException("a reason"))))
                .hasMessage("a.png: cannot be read: a reason");
    }
}
