package tompkins.ui.file;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.filechooser.FileFilter;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Asks for the name and the format of a file to save. */
public final class SaveDialog {

    private static final Pattern OTHER_ENDING = Pattern.compile(".*\\.(?!v\\d)\\p{Alpha}\\p{Alnum}{1,3}");

    private SaveDialog() {}

    /** Receives the name that was chosen. */
    @FunctionalInterface
    public interface Saver<T> {

        /**
         * Saves a file.
         *
         * @param replace whether the user knows that there is a file of this name, and wants it replaced. A file that
         *     appears later must not be
         */
        void save(Path file, T format, boolean replace);
    }

    /**
     * Asks for a name, and whether a file of that name may be written over.
     *
     * @param title what is to be saved
     * @param name what is proposed; without an ending, since that of the chosen format is added
     * @param formats the formats to choose from, the usual one first
     * @param saver takes the answer
     */
    public static <T> void ask(
            JFrame frame,
            JFileChooser chooser,
            String title,
            String name,
            List<FormatFilter<T>> formats,
            Saver<T> saver) {
        chooser.setDialogTitle(title);
        chooser.setAcceptAllFileFilterUsed(false);
        formats.forEach(chooser::addChoosableFileFilter);
        chooser.setFileFilter(formats.get(0));
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), name));
        while (chooser.showSaveDialog(frame) == JFileChooser.APPROVE_OPTION) {
            if (!EntryField.takeAll(chooser)) {
                // another field of the dialog has a wrong value, which is marked
                continue;
            }
            Optional<Path> chosen = ChosenFile.path(frame, chooser.getSelectedFile());
            if (chosen.isEmpty()) {
                continue;
            }
            Path typed = chosen.get();
            String typedName = typed.getFileName().toString();
            FormatFilter<T> format = meant(typedName, chooser.getFileFilter(), formats);
            if (typedName.equals(name) || !isOfAnotherKind(typedName, format)) {
                Path file = format.named(typed);
                boolean replace = !format.isFolder() && Files.exists(file);
                if (!replace || mayReplace(frame, file)) {
                    saver.save(file, format.format(), replace);
                    return;
                }
                continue;
            }
            String endings = formats.stream()
                    .flatMap(known -> known.endings().stream())
                    .distinct()
                    .collect(Collectors.joining(", "));
            Messages.error(frame, Texts.get("file.otherEnding", typedName, endings));
        }
    }

    /**
     * Whether a name has the ending of another kind of file; a dot may also stand before a number, as in
     * {@code beta0.9} and {@code lesson.v2}.
     */
    private static boolean isOfAnotherKind(String typed, FormatFilter<?> format) {
        return !format.isFolder()
                && !format.fits(typed)
                && OTHER_ENDING.matcher(typed).matches();
    }

    /** The format whose ending was typed, the chosen one before others; the chosen one if there is no such ending. */
    private static <T> FormatFilter<T> meant(String typed, FileFilter chosen, List<FormatFilter<T>> formats) {
        List<FormatFilter<T>> chosenFirst = new ArrayList<>(formats);
        chosenFirst.sort(Comparator.comparing(format -> format != chosen));
        return chosenFirst.stream()
                .filter(format -> format.fits(typed))
                .findFirst()
                .orElse(chosenFirst.get(0));
    }

    private static boolean mayReplace(JFrame frame, Path file) {
        return Messages.confirm(
                frame, Texts.get("file.overwriteTitle"), Texts.get("file.overwrite", file.getFileName()));
    }
}
