package tompkins.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import tompkins.file.FileException;
import tompkins.file.FileFailure;
import tompkins.file.WholeFile;
import tompkins.image.PhotographFile;
import tompkins.property.MistakeException;

/** Finds the text of a scene in a file: the file itself, or what a saved photograph holds. */
final class SceneText {

    /** The largest scene file, in bytes. */
    static final int LARGEST = 64 << 20;

    private static final int BYTE_ORDER_MARK = 0xfeff;

    /** With its bytes in the other order. */
    private static final int BYTE_ORDER_MARK_TURNED = 0xfffe;

    private final Path file;
    private final Problems problems;

    SceneText(Path file, Problems problems) {
        this.file = file;
        this.problems = problems;
    }

    /**
     * The text.
     *
     * @throws MistakeException if there is none
     */
    String read() {
        boolean isPiped = file.equals(StudioReader.PIPE);
        if (!isPiped) {
            requireFile();
        }
        try {
            byte[] content = isPiped ? System.in.readNBytes(WholeFile.LARGEST) : WholeFile.read(file);
            return PhotographFile.isPicture(file, content)
                    ? PhotographFile.readScene(content, file.toString()).orElseThrow(this::noScene)
                    : decoded(content);
        } catch (FileException unusable) {
            String start = file + ": ";
            String message = unusable.getMessage();
            throw problems.wholeFile(message.startsWith(start) ? message.substring(start.length()) : message);
        } catch (IOException failure) {
            throw problems.wholeFile("cannot be read: " + FileFailure.reason(failure));
        }
    }

    private void requireFile() {
        if (Files.isDirectory(file)) {
            throw problems.wholeFile("is a folder; a scene file or a saved photograph is needed");
        }
        // it is unknown what lies in a folder that may not be read; reading then fails, and says why
        if (Files.notExists(file)) {
            throw problems.wholeFile("there is no such file" + FileFailure.otherCase(file));
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw problems.wholeFile("is not a file");
        }
        String name = file.getFileName().toString();
        if (name.toLowerCase(Locale.ROOT).endsWith(".obj")) {
            throw problems.wholeFile("is a mesh, not a scene; an object of a scene shows it:"
                    + " { \"type\": \"TriangleMesh\", \"mesh\": " + Problems.quoted(name) + " }");
        }
    }

    private MistakeException noScene() {
        return problems.wholeFile("the picture holds no scene; only photographs saved by"
                + " this program do, and only until another program saves them again");
    }

    /** What is wrong with a text in UTF-16 or UTF-32, which some editors call Unicode; empty if it is in neither. */
    static Optional<String> wrongEncoding(byte[] content) {
        if (content.length < 2) {
            return Optional.empty();
        }
        // it is marked so, or has zeros in it
        int first = (content[0] & 0xff) << Byte.SIZE | content[1] & 0xff;
        boolean isWrong = first == BYTE_ORDER_MARK
                || first == BYTE_ORDER_MARK_TURNED
                || first >> Byte.SIZE == 0
                || (first & 0xff) == 0;
        return isWrong
                ? Optional.of("must be text in the encoding UTF-8, is in UTF-16 or UTF-32; save it again as UTF-8")
                : Optional.empty();
    }

    private String decoded(byte[] content) {
        if (content.length > LARGEST) {
            throw problems.wholeFile("a scene file may have at most " + LARGEST + " bytes, has " + content.length);
        }
        Optional<String> wrong = wrongEncoding(content);
        if (wrong.isPresent()) {
            throw problems.wholeFile(wrong.get());
        }
        CharsetDecoder decoder = StandardCharsets.UTF_8
                .newDecoder()
                .onMalformedInput(CodingErrorAction.REPORT)
                .onUnmappableCharacter(CodingErrorAction.REPORT);
        ByteBuffer bytes = ByteBuffer.wrap(content);
        CharBuffer text = CharBuffer.allocate(content.length);
        CoderResult result = decoder.decode(bytes, text, true);
        text.flip();
        if (result.isError()) {
            String before = text.toString();
            int line = (int) before.chars().filter(letter -> letter == '\n').count() + 1;
            int column = before.length() - before.lastIndexOf('\n');
            String unexpected = String.format(Locale.ROOT, "0x%02x", content[bytes.position()]);
            problems.add(line, column, "", "must be text in the encoding UTF-8, has here the byte " + unexpected);
            throw problems.exception();
        }
        boolean marked = text.length() > 0 && text.charAt(0) == BYTE_ORDER_MARK;
        return marked ? text.subSequence(1, text.length()).toString() : text.toString();
    }
}
