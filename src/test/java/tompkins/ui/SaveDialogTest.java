package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JFileChooser;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.Descriptions;
import tompkins.studio.Studios;
import tompkins.ui.widget.Texts;

/** The format in which a file is saved: the one whose ending is typed, else the chosen one. */
class SaveDialogTest extends WindowFixture {

    /** Where a PNG file says how many bits a channel has. */
    private static final int PNG_DEPTH = 24;

    @BeforeEach
    void open() {
        driver = new WindowDriver(
                folder.resolve("settings"), Studios.sphere(), folder.resolve("sphere.json"), List.of());
        driver.completePicture();
    }

    private void awaitSaved(Path file) {
        await(file.toString(), () -> driver.said().equals("Saved " + file));
    }

    private void chooseFormat(String description) {
        JFileChooser chooser = driver.chooser();
        onEventThread(() -> List.of(chooser.getChoosableFileFilters()).stream()
                .filter(filter -> description.equals(filter.getDescription()))
                .forEach(chooser::setFileFilter));
    }

    @Test
    void aTypedEndingStandsForItsFormatTheChosenOneFirst() throws IOException {
        driver.menu("menu.savePhotograph");
        Path tiff = folder.resolve("typed.tif");
        driver.choose(tiff);
        awaitSaved(tiff);
        assertThat(start(tiff)).isIn("II*\0", "MM\0*");
        driver.menu("menu.savePhotograph");
        chooseFormat("PNG, 16 bits per channel");
        Path png = folder.resolve("typed.png");
        driver.choose(png);
        awaitSaved(png);
        assertThat(Files.readAllBytes(png)[PNG_DEPTH]).isEqualTo((byte) 16);

        driver.menu("menu.playPanel");
        driver.answer(Texts.get("play.export"));
        Path gif = folder.resolve("typed.gif");
        driver.choose(gif);
        awaitSaved(gif);
        assertThat(start(gif)).isEqualTo("GIF8");
    }

    @Test
    void anEndingOfAnotherKindOfFileIsRefused() throws IOException {
        driver.menu("menu.savePhotograph");
        Path jpeg = folder.resolve("typed.jpg");
        driver.choose(jpeg);
        await(
                "the message",
                () -> driver.showing(JTextArea.class)
                        .anyMatch(
                                message -> message.getText()
                                        .equals(
                                                "The name typed.jpg has the ending of another kind of file; it must end in .png, .tif, .tiff, .hdr, .pic, or have no ending.")));
        driver.answer("OK");
        driver.choose(folder.resolve("beta0.9"));
        awaitSaved(folder.resolve("beta0.9.png"));
        driver.menu("menu.savePhotograph");
        driver.choose(folder.resolve("lesson.v2"));
        awaitSaved(folder.resolve("lesson.v2.png"));
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).noneMatch(file -> file.toString().contains("jpg"));
        }
    }

    @Test
    void sizeAndQualityOfAPhotographAreAsked() throws IOException {
        driver.menu("menu.savePhotograph");
        driver.chooser();
        JTextField width = driver.find(JTextField.class, "Width");
        assertThat(width.getText()).isEqualTo("" + driver.studio().settings().width());
        Container chooser = driver.chooser();
        onEventThread(() -> {
            Components.enter(chooser, "Width", "1e308");
            assertThat(Components.notes(chooser))
                    .anyMatch(text -> text.contains("a whole number from 1 to 65535, was 1e308"));
            Components.enter(chooser, "Width", "96");
            Components.enter(chooser, "Target error", "0.01");
            Components.enter(chooser, "Samples", "3");
            assertThat(Components.find(chooser, JTextField.class, "Target error")
                            .getText())
                    .as("samples stand for themselves")
                    .isEqualTo("0");
        });
        Path png = folder.resolve("small.png");
        driver.choose(png);
        awaitSaved(png);
        assertThat(StudioReader.read(png).settings().samples()).isEqualTo(3);
        BufferedImage saved = ImageIO.read(png.toFile());
        assertThat(saved.getWidth()).isEqualTo(96);
        assertThat(saved.getHeight()).isEqualTo(72);
        assertThat(driver.studio().settings().width()).as("the scene").isNotEqualTo(96);
    }

    private static String start(Path file) throws IOException {
        return new String(Files.readAllBytes(file), 0, 4, StandardCharsets.ISO_8859_1);
    }

    /** A dot in the name of a scene begins no ending. */
    @Test
    void theProposedNameGetsTheEndingOfTheChosenFormat() throws IOException {
        driver.open(Studios.sphere(), folder.resolve("sphere.v2.json"));
        driver.menu("menu.savePhotograph");
        chooseFormat("Radiance HDR");
        driver.answer("Save");
        Path hdr = folder.resolve("sphere.v2.hdr");
        awaitSaved(hdr);
        assertThat(start(hdr)).startsWith("#?");
    }

    @Test
    void aSceneWithoutAFileIsOfferedItsTitleAsName() {
        String title = "Fig. 1(b): camera at 99.5 % of the speed of light";
        driver.open(Descriptions.with(Studios.sphere(), "title", title), null);
        for (String item : List.of("menu.saveScene", "menu.savePhotograph")) {
            driver.menu(item);
            assertThat(driver.chooser().getSelectedFile())
                    .isEqualTo(folder.resolve("Fig-1-b").toFile());
            driver.answer("Cancel");
            await("the end of the file chooser", () -> !driver.isChooserOpen());
        }
        driver.menu("menu.playPanel");
        driver.answer(Texts.get("play.export"));
        assertThat(driver.chooser().getCurrentDirectory()).isEqualTo(folder.toFile());
        assertThat(driver.chooser().getFileFilter().getDescription())
                .as("the usual format")
                .isEqualTo(Texts.get("format.GIF"));
        driver.answer("Cancel");
    }

    @Test
    void theFolderOfTheLastFileIsKeptForTheNext() throws IOException {
        Path exports = Files.createDirectory(folder.resolve("exports"));
        driver.menu("menu.savePhotograph");
        Path png = exports.resolve("first.png");
        driver.choose(png);
        awaitSaved(png);
        assertThat(folderOfTheChooser("menu.savePhotograph")).isEqualTo(exports);
        assertThat(folderOfTheChooser("menu.saveSceneAs")).isEqualTo(exports);

        Path other = folder.resolve("other.json");
        StudioWriter.save(Studios.lattice(), other, true);
        driver.menu("menu.open");
        driver.choose(other);
        await("the scene", () -> driver.studio().equals(Studios.lattice()));
        assertThat(folderOfTheChooser("menu.savePhotograph")).isEqualTo(folder);
    }

    /** Pictures with numbers go into a folder without anything else in it. */
    @Test
    void anExportThatFailedIsForgotten() throws IOException {
        Path full = Files.createDirectories(folder.resolve("elsewhere").resolve("full"));
        Files.writeString(full.resolve("mine.txt"), "mine");
        driver.menu("menu.playPanel");
        driver.answer(Texts.get("play.export"));
        chooseFormat("Folder of numbered PNG pictures");
        driver.choose(full);
        driver.answer("OK");
        assertThat(folderOfTheChooser("menu.savePhotograph")).isEqualTo(folder);

        Path exports = Files.createDirectory(folder.resolve("exports"));
        driver.answer(Texts.get("play.export"));
        Path gif = exports.resolve("moving.gif");
        driver.choose(gif);
        awaitSaved(gif);
        assertThat(folderOfTheChooser("menu.savePhotograph")).isEqualTo(exports);
    }

    private Path folderOfTheChooser(String item) {
        driver.menu(item);
        Path current = driver.chooser().getCurrentDirectory().toPath();
        driver.answer("Cancel");
        await("the end of the file chooser", () -> !driver.isChooserOpen());
        return current;
    }
}
