package tompkins;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.UnaryOperator;

/**
 * Tables of wrong input and of what the program says of it: each input on a line of its own, with the escapes of Java,
 * and below it the message, indented. {@code -Dtompkins.regenerate=true} writes the messages again.
 */
public final class MessageTable {

    private static final String INDENT = "    ";

    private MessageTable() {}

    /** Fails if the message of an input is not that of the table, or speaks of the insides of the program. */
    public static void assertTold(String resource, UnaryOperator<String> message, Class<?> test) throws IOException {
        Path file = GeneratedDocument.resource(resource);
        StringBuilder table = new StringBuilder();
        for (String line : Files.readAllLines(file)) {
            if (line.isEmpty() || line.startsWith("#")) {
                table.append(line).append('\n');
            } else if (!line.startsWith(INDENT)) {
                String told = message.apply(line.translateEscapes());
                assertThat(told).as(line).isNotBlank().doesNotContain("Exception", "\tat ", "\u001b");
                table.append(line).append('\n').append(told.indent(INDENT.length()));
            }
        }
        GeneratedDocument.assertUpToDate(file, table.toString(), test);
    }
}
