package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PictureFormat;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.sceneobject.Box;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.file.BackgroundTask;

/** Scene files that other programs write, too: nothing in them is lost without a question. */
class SceneFilesTest extends WindowFixture {

    private static final Studio BOX = Studios.sphere().withScene(List.of(Box.DEFAULT));

    private Path file;

    @BeforeEach
    void open() throws IOException {
        file = folder.resolve("sphere.json");
        StudioWriter.save(Studios.sphere(), file, true);
        driver = new WindowDriver(folder.resolve("settings"), Studios.sphere(), file, List.of());
    }

    /** Changes the speed in the window. */
    private Studio change(String speed) {
        driver.type(driver.find(JTextField.class, "Speed"), speed);
        return driver.studio();
    }

    private void save() {
        driver.menu("menu.saveScene");
    }

    private void awaitSaved() {
        await("the saved scene", () -> !driver.window().model().isModified());
    }

    private void assertSavesWithoutAQuestion(String speed) {
        Studio next = change(speed);
        save();
        awaitSaved();
        assertThat(StudioReader.read(file)).isEqualTo(next);
    }

    /** Asserts that the file stays as it is until the user agrees; from then on no save asks. */
    private void assertSavesOnlyAnyway(Studio mine) throws IOException {
        byte[] before = Files.readAllBytes(file);
        save();
        driver.answer("Cancel");
        assertThat(file).hasBinaryContent(before);
        save();
        driver.answer("Save anyway");
        awaitSaved();
        assertThat(StudioReader.read(file)).isEqualTo(mine);
        assertSavesWithoutAQuestion("0.6");
    }

    private void awaitStudio(Studio studio) {
        await("the scene", () -> driver.studio().equals(studio));
    }

    /** A save that goes on until somebody stops it. */
    private CountDownLatch saveSlowly() {
        CountDownLatch stopped = new CountDownLatch(1);
        onEventThread(() -> {
            BackgroundTask.start(
                    driver.window().frame(),
                    "Saving slowly",
                    file,
                    task -> {
                        while (!task.isCancelled()) {
                            assertThat(stopped.await(1, TimeUnit.MILLISECONDS)).isFalse();
                        }
                        task.requireWanted();
                        return null;
                    },
                    nothing -> {},
                    stopped::countDown);
        });
        return stopped;
    }

    /** Until then it is not saved again: a second writer might be faster than the first. */
    @Test
    void escapeStopsASave() throws InterruptedException {
        CountDownLatch stopped = saveSlowly();
        save();
        await("the answer", () -> driver.said().startsWith("Still saving " + file));
        onEventThread(() -> {
            JRootPane pane = driver.window().frame().getRootPane();
            KeyStroke escape = KeyStroke.getKeyStroke("ESCAPE");
            Object action = pane.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(escape);
            pane.getActionMap().get(action).actionPerformed(new ActionEvent(pane, ActionEvent.ACTION_PERFORMED, ""));
        });
        assertThat(stopped.await(5, TimeUnit.MINUTES)).isTrue();
    }

    @Test
    void closingDuringASaveAsks() throws InterruptedException {
        CountDownLatch stopped = saveSlowly();
        JFrame frame = driver.window().frame();
        driver.menu("menu.close");
        driver.answer("Stop it and close");
        assertThat(stopped.await(5, TimeUnit.MINUTES)).isTrue();
        await("the end of the window", () -> !frame.isDisplayable());
    }

    @Test
    void whatIsDroppedIsOpened() throws IOException {
        Path box = folder.resolve("box.json");
        StudioWriter.save(BOX, box, true);
        assertThat(drop(box, file)).as("of several the first").isTrue();
        awaitStudio(BOX);
        assertThat(driver.window().model().file()).isEqualTo(box);
        Path wrong = Files.writeString(folder.resolve("wrong.json"), "no scene");
        assertThat(drop(wrong)).isTrue();
        driver.answer("OK");
        assertThat(drop(folder.resolve("missing.json"))).isTrue();
        driver.answer("OK");
        assertThat(driver.studio()).isEqualTo(BOX);
        assertThat(box).exists();
    }

    private boolean drop(Path... dropped) {
        JRootPane pane = driver.window().frame().getRootPane();
        return onEventThread(() -> pane.getTransferHandler()
                .importData(new TransferHandler.TransferSupport(pane, new DroppedFiles(List.of(dropped)))));
    }

    /** Files on their way from another program. */
    private record DroppedFiles(List<Path> files) implements Transferable {

        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavour) {
            return flavour.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavour) {
            return files.stream().map(Path::toFile).toList();
        }
    }

    @Test
    void commentsAreWrittenOverOnlyWhenTheUserAgrees() throws IOException {
        Files.writeString(file, "// mine\n" + Files.readString(file));
        assertSavesOnlyAnyway(change("0.5"));
    }

    /** Enter alone loses nothing. */
    @Test
    void theFirstAnswerSavesElsewhere() throws IOException {
        Files.writeString(file, "// mine\n" + Files.readString(file));
        byte[] before = Files.readAllBytes(file);
        Studio mine = change("0.5");
        save();
        driver.answerWithEnter("Save scene as\u2026");
        Path other = folder.resolve("other.json");
        driver.choose(other);
        awaitSaved();
        assertThat(file).hasBinaryContent(before);
        assertThat(StudioReader.read(other)).isEqualTo(mine);
    }

    @Test
    void reloadingAsksWhatBecomesOfChanges() throws IOException {
        Studio mine = change("0.5");
        StudioWriter.save(BOX, file, true);
        driver.menu("menu.reload");
        driver.answer("Cancel");
        assertThat(driver.studio()).isEqualTo(mine);
        driver.menu("menu.reload");
        driver.answer("Discard");
        awaitStudio(BOX);
    }

    @Test
    void aSceneIsSavedToItsFileWhateverItsEnding() throws IOException {
        Path other = folder.resolve("sphere.v2");
        StudioWriter.save(BOX, other, true);
        openFile(other);
        Studio mine = change("0.5");
        save();
        awaitSaved();
        assertThat(StudioReader.read(other)).isEqualTo(mine);
    }

    @Test
    void anotherSceneClearsWhatWasSaidOfTheOneBefore() throws IOException {
        change("0.5");
        save();
        await("the message", () -> driver.said().equals("Saved " + file));
        JTextField aperture = driver.find(JTextField.class, "Aperture");
        driver.type(aperture, "-1");
        assertThat(Components.isMarked(aperture)).isTrue();
        Path other = folder.resolve("box.json");
        StudioWriter.save(BOX, other, true);
        openFile(other);
        assertThat(driver.said()).doesNotContain("Saved");
        assertThat(Components.isMarked(aperture)).isFalse();
    }

    @Test
    void anExampleThatWasOnlyLookedAtIsLeftWithoutAQuestion() throws IOException {
        driver.open(Studios.sphere(), null);
        Studio fast = change("0.5");
        Path other = folder.resolve("box.json");
        StudioWriter.save(BOX, other, true);
        openFile(other);
        driver.menu("menu.undo");
        awaitStudio(fast);

        driver.set(fast.withScene(List.of()));
        driver.menu("menu.open");
        driver.answer("Cancel");
        assertThat(driver.studio().scene()).isEmpty();
    }

    @Test
    void aSceneIsNotSavedOverThePhotographThatHoldsIt() throws IOException {
        Path photograph = folder.resolve("photograph");
        Files.copy(photograph(BOX), photograph);
        byte[] before = Files.readAllBytes(photograph);
        openFile(photograph);
        Studio mine = change("0.5");
        save();
        driver.choose(folder.resolve("box"));
        awaitSaved();
        assertThat(StudioReader.read(folder.resolve("box.json"))).isEqualTo(mine);
        assertThat(photograph).hasBinaryContent(before);
    }

    private void openFile(Path other) {
        driver.menu("menu.open");
        driver.choose(other);
        awaitStudio(BOX);
    }

    private Path photograph(Studio studio) throws IOException {
        Path photograph = folder.resolve("photograph.png");
        LinearImage black = new LinearImage(1, 1, new float[3]);
        PhotographFile.write(
                photograph, black, PictureFormat.PNG, studio.settings().toneCurve(), SelfDescription.of(studio), true);
        return photograph;
    }

    @Test
    void anExampleIsReloadedAsItWasOpened() {
        driver.open(BOX, null);
        driver.set(BOX.withVelocity(Velocity.of(0, 0, 0.5)));
        driver.key(KeyEvent.VK_F5);
        awaitStudio(BOX);
        assertThat(driver.window().model().isModified()).isFalse();
    }
}
