package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpServer;
import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JToolTip;
import javax.swing.JTree;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.io.StudioWriter;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/**
 * Names that would be HTML with a picture from a server, in everything that is shown: Swing must neither lay them out
 * nor ask the server.
 */
class PlainTextTest extends WindowFixture {

    private final AtomicInteger asked = new AtomicInteger();
    private final List<String> shown = new ArrayList<>();
    private HttpServer server;
    private String html;

    @BeforeEach
    void open() throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", exchange -> {
            asked.incrementAndGet();
            exchange.close();
        });
        server.start();
        // no slash, which a file's name cannot have, but one that is escaped
        html = "<html><img src=http:&#47;&#47;127.0.0.1:" + server.getAddress().getPort() + "&#47;a.png>";
        Path inside = Files.createDirectories(folder.resolve(html).resolve(html));
        Path file = inside.resolve(html + ".json");
        Studio evil = Descriptions.with(Studios.sphere(), "title", html);
        evil = Descriptions.with(evil, "remarks", html)
                .withScene(List.of(Descriptions.with(Sphere.DEFAULT, "description", html)));
        StudioWriter.save(evil, file, true);
        driver = new WindowDriver(folder.resolve("settings"), evil, file, List.of(evil));
        driver.completePicture();
    }

    @AfterEach
    void stop() {
        server.stop(0);
    }

    @Test
    void windowMenusTreeAndTipsShowNamesAsTheyStand() {
        driver.menu("menu.editScene");
        await("the form", () -> driver.window().side.isEditing());
        onEventThread(() -> {
            // what is filled when it is opened
            Components.all(driver.window().frame())
                    .filter(JMenu.class::isInstance)
                    .forEach(menu -> ((JMenu) menu).setSelected(true));
            JTree tree = driver.find(JTree.class, "tree");
            for (int row = 0; row < tree.getRowCount(); row++) {
                tree.expandRow(row);
            }
            tree.setSelectionRow(2);
        });
        requirePlain();
        assertThat(shown)
                .as("in the menu of files, its tips, the examples, and the tree")
                .filteredOn(text -> text.contains("<html>"))
                .hasSizeGreaterThan(3);
    }

    @Test
    void fileChooserShowsNamesAsTheyStand() {
        driver.menu("menu.open");
        JFileChooser chooser = driver.chooser();
        await(
                "the files",
                () -> Components.showing(chooser, JList.class)
                        .anyMatch(list -> list.getModel().getSize() > 0));
        requirePlain();
        assertThat(shown)
                .as("file, folder, folder above")
                .filteredOn(text -> text.startsWith("<html>"))
                .hasSizeGreaterThan(2);
        onEventThread(chooser::cancelSelection);
    }

    @Test
    void questionsAndMessagesShowNamesAsTheyStand() {
        WindowDriver.later(() -> Messages.error(driver.window().frame(), html));
        await("the message", () -> Components.messages(driver.window().frame()).anyMatch(html::equals));
        requirePlain();
        driver.answer("OK");
        WindowDriver.later(() -> Messages.askAboutChanges(driver.window().frame(), html));
        await(
                "the question",
                () -> driver.showing(JButton.class)
                        .anyMatch(button -> Texts.get("unsaved.save").equals(button.getText())));
        requirePlain();
        driver.answer(Texts.get("task.cancel"));
    }

    private void requirePlain() {
        onEventThread(() -> {
            for (Window window : Window.getWindows()) {
                Components.all(window).forEach(this::requirePlain);
            }
        });
        assertThat(asked).as("questions to the server").hasValue(0);
    }

    private void requirePlain(Component component) {
        if (component instanceof JComponent swing) {
            assertThat(swing.getClientProperty(BasicHTML.propertyKey))
                    .as(swing.toString())
                    .isNull();
            note(swing);
            if (swing.getToolTipText() != null) {
                JToolTip tip = swing.createToolTip();
                tip.setTipText(swing.getToolTipText());
                assertThat(tip.getClientProperty(BasicHTML.propertyKey)).isNull();
                shown.add(swing.getToolTipText());
            }
        }
        cells(component).forEach(this::requirePlain);
    }

    private void note(JComponent component) {
        String text = component.getAccessibleContext() == null
                ? null
                : component.getAccessibleContext().getAccessibleName();
        if (text != null) {
            shown.add(text);
        }
    }

    /** What draws the lines of lists and trees, for each line. */
    private static Stream<Component> cells(Component component) {
        List<Component> cells = new ArrayList<>();
        if (component instanceof JList<?> list) {
            addCells(list, cells);
        } else if (component instanceof JComboBox<?> box) {
            JList<Object> list = new JList<>();
            for (int i = 0; i < box.getItemCount(); i++) {
                cells.add(cell(box, list, i));
            }
        } else if (component instanceof JTree tree) {
            for (int row = 0; row < tree.getRowCount(); row++) {
                Object line = tree.getPathForRow(row).getLastPathComponent();
                cells.add(tree.getCellRenderer()
                        .getTreeCellRendererComponent(tree, line, false, false, true, row, false));
            }
        }
        return cells.stream()
                .flatMap(cell -> cell instanceof Container container ? Components.all(container) : Stream.of(cell));
    }

    private static <T> void addCells(JList<T> list, List<Component> cells) {
        for (int i = 0; i < list.getModel().getSize(); i++) {
            cells.add(list.getCellRenderer()
                    .getListCellRendererComponent(list, list.getModel().getElementAt(i), i, false, false));
        }
    }

    private static <T> Component cell(JComboBox<T> box, JList<Object> list, int index) {
        @SuppressWarnings("unchecked") // a renderer looks at no more than the colours of a list
        JList<T> typed = (JList<T>) list;
        return box.getRenderer().getListCellRendererComponent(typed, box.getItemAt(index), index, false, false);
    }
}
