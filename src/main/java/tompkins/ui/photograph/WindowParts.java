package tompkins.ui.photograph;

import javax.swing.JFrame;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;

/**
 * What the commands of a window work with.
 *
 * @param frame the window, over which their dialogs are
 * @param model the studio with its history
 * @param view the photograph
 * @param status says in a line what became of a command
 * @param settings what the window remembers
 */
public record WindowParts(JFrame frame, StudioModel model, PhotographView view, StatusBar status, Settings settings) {}
