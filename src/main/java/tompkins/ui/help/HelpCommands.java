package tompkins.ui.help;

import java.util.List;
import javax.swing.JFrame;
import javax.swing.JMenuItem;
import tompkins.io.SelfDescription;
import tompkins.ui.exchange.SceneOpener;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** What the program tells about itself: its documents, its keys, its version. */
public final class HelpCommands {

    private final JFrame frame;
    private final SceneOpener opener;

    /** Made when it is first wanted. */
    private HelpWindow documents;

    /** The help of a window; {@code opener} opens the scenes that the documents link to. */
    public HelpCommands(JFrame frame, SceneOpener opener) {
        this.frame = frame;
        this.opener = opener;
    }

    /** Shows a page of the documents, named by its file. */
    public void showDocument(String page) {
        if (documents == null) {
            documents = new HelpWindow(frame, opener::open);
        }
        documents.show(HelpPage.of(page));
    }

    /** Shows the keys of some items, and all others. */
    public void showKeys(List<JMenuItem> items) {
        KeyTable keys = new KeyTable(items);
        keys.fitInto(Messages.width(frame));
        Messages.tell(frame, Texts.get("menu.keys"), keys.component());
    }

    /** Says which program this is. */
    public void showAbout() {
        Messages.tell(
                frame,
                Texts.get("menu.about"),
                Texts.get("help.about", SelfDescription.program(), System.getProperty("java.version")));
    }
}
