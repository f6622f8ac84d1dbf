package tompkins.ui;

import java.awt.Dimension;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.JRootPane;
import tompkins.studio.StudioPath;
import tompkins.ui.editor.FileContentEditor;
import tompkins.ui.editor.SceneEditor;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

/** The editor of the studio in a window beside that of the photograph; made when it is first asked for. */
final class EditorDialog {

    /** On a screen that is narrower, in sizes of the type, it must be narrow to leave enough of the picture. */
    private static final double WIDE_SCREEN = 120;

    private final WindowParts window;
    private final FileContentEditor.Choosers choosers;
    private final Consumer<JRootPane> keys;
    private JDialog dialog;
    private SceneEditor editor;

    /**
     * The editor of a window.
     *
     * @param keys binds those of the menus in the editor, too
     */
    EditorDialog(WindowParts window, FileContentEditor.Choosers choosers, Consumer<JRootPane> keys) {
        this.window = window;
        this.choosers = choosers;
        this.keys = keys;
    }

    /** Shows the editor as it was left. */
    void open() {
        if (dialog == null) {
            make();
        }
        dialog.setVisible(true);
    }

    /** Shows the editor at a part of the studio, unless a wrong value in it must be corrected first. */
    void open(StudioPath part) {
        open();
        editor.choose(part);
        dialog.toFront();
    }

    /** Whether it is on the screen. */
    boolean isOpen() {
        return dialog != null && dialog.isVisible();
    }

    private void make() {
        editor = new SceneEditor(window.model());
        dialog = new JDialog(window.frame(), Texts.get("tree.title"));
        dialog.setName("editor");
        dialog.setContentPane(editor.component());
        dialog.getRootPane().putClientProperty(FileContentEditor.CHOOSERS, choosers);
        keys.accept(dialog.getRootPane());
        Keys.bindEscape(dialog.getRootPane(), () -> dialog.setVisible(false));
        fitToLook();
        Screens.moveBeside(dialog, window.frame());
        // while it is there lamps are marked, and a click chooses
        dialog.getRootPane().addHierarchyListener(event -> {
            window.view().canvas().repaint();
            window.view().tellTool();
        });
    }

    /** Makes it as large as it needs to be, and not smaller than the user has made it. */
    void fitToLook() {
        if (dialog != null) {
            Dimension made = dialog.getSize();
            editor.fitToLook(Screens.room(window.frame()).width < Look.pixels(WIDE_SCREEN));
            dialog.pack();
            dialog.setSize(Math.max(made.width, dialog.getWidth()), Math.max(made.height, dialog.getHeight()));
            Screens.keepOnScreen(dialog);
        }
    }

    void dispose() {
        if (dialog != null) {
            dialog.dispose();
        }
    }
}
